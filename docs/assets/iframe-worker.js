// Browsers start no worker for a page that was opened as a file. Its script runs in a frame instead,
// so that the search of the manual works without a server.
if (location.protocol === "file:") {
  class IFrameWorker extends EventTarget {
    constructor(url) {
      super();
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      document.body.appendChild(this.frame);
      const inside = this.frame.contentWindow;
      inside.answer = (data) => this.dispatchEvent(new MessageEvent("message", {data}));
      inside.failed = (error) => this.dispatchEvent(new ErrorEvent("error", {error}));
      this.loaded = new Promise((resolve) => { inside.ready = resolve; });
      inside.document.open();
      inside.document.write(`<!doctype html><script>
        window.postMessage = (data) => answer(data);
        window.importScripts = (...urls) => urls.reduce((before, url) => before.then(() =>
          new Promise((resolve) => {
            const script = document.createElement("script");
            script.src = url;
            script.onload = script.onerror = resolve;
            document.body.appendChild(script);
          })), Promise.resolve());
        window.addEventListener("error", (event) => failed(event.error));
      <\/script><body><script src="${url}" onload="ready()"><\/script></body>`);
      inside.document.close();
    }

    postMessage(data) {
      this.loaded.then(() => {
        const {contentWindow} = this.frame;
        contentWindow.dispatchEvent(new contentWindow.MessageEvent("message", {data}));
      });
    }

    terminate() {
      this.frame.remove();
    }
  }
  window.IFrameWorker = IFrameWorker;
  window.Worker = IFrameWorker;
}
