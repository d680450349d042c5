/* A button for light and dark; the choice is kept. */
(function () {
	const root = document.documentElement;
	const kept = (() => { try { return localStorage.getItem("theme"); } catch { return null; } })();

	if (kept) root.dataset.theme = kept;
	document.addEventListener("DOMContentLoaded", () => {
		const button = document.createElement("button");
		const dark = () => (root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
		const name = () => { button.textContent = dark() ? "light" : "dark"; };

		button.id = "theme";
		button.title = "light or dark page";
		button.onclick = () => {
			root.dataset.theme = dark() ? "light" : "dark";
			try { localStorage.setItem("theme", root.dataset.theme); } catch { /* not kept */ }
			name();
		};
		name();
		document.body.append(button);
	});
})();
