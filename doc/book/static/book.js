/* A button for light and dark, whose choice is kept; the contents beside a page show where it is, and are closed on a narrow
   screen; a search in a book that is opened as a file has excerpts. */
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
	/* Sphinx's search fetches the pages found and shows a part of their main text. Files cannot be fetched, but a script can
	   bring all texts. */
	let texts;
	function load() {
		return texts ??= new Promise((done) => {
			const script = document.createElement("script");

			script.src = "searchtexts.js";
			script.onload = script.onerror = () => done(window.searchTexts || {});
			document.head.append(script);
		});
	}
	if (location.protocol === "file:")
		window.fetch = async (address) => {
			const all = await load();
			const main = document.createElement("div");

			main.setAttribute("role", "main");
			main.textContent = all[address.replace(/^\.\/|\.html$/g, "")] || "";
			return { text: async () => main.textContent && main.outerHTML };
		};
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
