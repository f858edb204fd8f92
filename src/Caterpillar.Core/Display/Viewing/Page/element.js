// A print as an element of any page: <script src="bracket.js"></script><caterpillar-viewer></caterpillar-viewer>. Several such scripts share the element.
(() => {
  "use strict";
  const title = {{title}}, page = {{page}};
  const name = "caterpillar-viewer", parts = ["color", "layers", "at", "line", "cut", "view", "show", "hide"];

  class Viewer extends HTMLElement {
    static prints = new Map();

    static observedAttributes = ["print", "theme", ...parts];

    connectedCallback() {
      const root = this.shadowRoot ?? this.attachShadow({ mode: "open" });
      root.innerHTML = "<style>:host { display: block; height: 600px } :host([hidden]) { display: none }"
        + " iframe { display: block; width: 100%; height: 100%; border: 0 }</style><iframe></iframe>";
      this.frame = root.querySelector("iframe");
      this.hear = ({ source, data }) => {
        if (source === this.frame.contentWindow && data?.moment) this.dispatchEvent(new CustomEvent("moment", { detail: data.moment, bubbles: true }));
      };
      window.addEventListener("message", this.hear);
      this.update();
    }

    disconnectedCallback() {
      window.removeEventListener("message", this.hear);
      this.leave();
    }

    attributeChangedCallback() {
      if (this.isConnected && this.frame) this.update();
    }

    leave() {
      if (this.address) URL.revokeObjectURL(this.address);
      this.address = this.shown = null;
    }

    // The print that the attribute names, or the first; what else is chosen stands in the address of the frame.
    update() {
      const print = this.getAttribute("print") ?? Viewer.prints.keys().next().value;
      if (!Viewer.prints.has(print)) return;
      if (this.shown !== print) {
        this.leave();
        this.shown = print;
        this.address = URL.createObjectURL(new Blob([Viewer.prints.get(print)], { type: "text/html" }));
        this.frame.title = `Print ${print}`;
      }
      const chosen = parts.filter((part) => this.hasAttribute(part)).map((part) => `${part}=${encodeURIComponent(this.getAttribute(part))}`);
      if (this.hasAttribute("theme")) chosen.push(this.getAttribute("theme"));
      this.frame.src = `${this.address}#${chosen.join("&")}`;
    }
  }

  if (!customElements.get(name)) customElements.define(name, Viewer);
  customElements.get(name).prints.set(title, page);
  for (const element of document.querySelectorAll(name)) element.update?.();
})();
