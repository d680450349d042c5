/* A button for light and dark, whose choice is kept; the contents beside a page show where it is, and are closed on a narrow
   screen. */
(function () {
	const root = document.documentElement;
	const kept = (() => { try { return localStorage.getItem("theme"); } catch { return null; } })();

	if (kept) root.dataset.theme = kept;
	function contents() {
		const side = document.querySelector("div.sphinxsidebar");
		const first = side?.querySelector("h3:not(#searchlabel)");
		if (!first) return;
		const box = document.createElement("details");
		const title = document.createElement("summary");

		title.textContent = "Contents";
		box.id = "contents";
		box.open = !matchMedia("(max-width: 875px)").matches;
		first.before(box);
		box.append(title);
		while (box.nextSibling) box.append(box.nextSibling);
		const here = [...box.querySelectorAll("li.current")].pop();
		if (here && here.offsetTop > innerHeight) side.scrollTop = here.offsetTop - innerHeight / 2;
	}
	document.addEventListener("DOMContentLoaded", () => {
		contents();
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
