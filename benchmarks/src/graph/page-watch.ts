/**
 * Script that runs in a page before its own: remembers frames and when the graph stood, and hides the
 * page. Headless pages are never hidden, so that this does what a browser does: says so, and draws no
 * frames.
 */
const nextFrame = globalThis.requestAnimationFrame.bind(globalThis);
const waiting = new Map<number, FrameRequestCallback>();
let waitingId = -1;
let isHidden = false;
let frames: number[] | undefined;
let changes = 0;
let noted: { readonly element: Element; readonly text: string }[] = [];

globalThis.requestAnimationFrame = (callback) => {
  if (!isHidden) return nextFrame(callback);
  waiting.set(--waitingId, callback);
  return waitingId;
};
const cancel = globalThis.cancelAnimationFrame.bind(globalThis);
globalThis.cancelAnimationFrame = (id) => {
  if (!waiting.delete(id)) cancel(id);
};
Object.defineProperty(document, 'visibilityState', {
  get: () => (isHidden ? 'hidden' : 'visible'),
});
Object.defineProperty(document, 'hidden', { get: () => isHidden });
const observer = new MutationObserver((records) => (changes += records.length));

const nodeElements = () => [...document.querySelectorAll<HTMLElement>('[data-graph-node]')];
function watchFrame(timeMs: number): void {
  frames?.push(timeMs);
  if (frames !== undefined) nextFrame(watchFrame);
}

const pageWatch = {
  /** Resolves with the time since navigation when so many nodes have been drawn, ms. */
  ready: (count: number): Promise<number> =>
    new Promise((resolve) => {
      const look = (): void => {
        if (document.querySelectorAll('[data-graph-node]').length < count) nextFrame(look);
        // The frame after the next one begins when the next one is drawn.
        else nextFrame(() => nextFrame(() => resolve(performance.now())));
      };
      look();
    }),
  start(): void {
    frames = [];
    nextFrame(watchFrame);
  },
  /** @returns times between frames, ms */
  stop(): number[] {
    const times = frames ?? [];
    frames = undefined;
    return times.slice(1).map((timeMs, index) => timeMs - times[index]!);
  },
  /** Position and scale of a node on the page. */
  place(id: string): { x: number; y: number; scale: number } {
    const element = nodeElements().find(({ dataset }) => dataset['graphNode'] === id)!;
    const { left, top, width } = element.getBoundingClientRect();
    return { x: left, y: top, scale: width / element.offsetWidth };
  },
  /** The node next to a point of the page that can be pressed there. */
  nodeNear(x: number, y: number): string {
    const distance = (element: HTMLElement): number => {
      const { left, top } = element.getBoundingClientRect();
      return Math.hypot(left - x, top - y);
    };
    const [nearest] = nodeElements().sort((a, b) => distance(a) - distance(b));
    return nearest!.dataset['graphNode']!;
  },
  /** Remembers the values of ports that are on the canvas. */
  noteValues(): void {
    const canvas = document.querySelector('[role=application]')!.getBoundingClientRect();
    noted = [...document.querySelectorAll('[data-row-port] [data-live]')]
      .filter((element) => {
        const { left, top, right, bottom } = element.getBoundingClientRect();
        const isAcross = right > canvas.left && left < canvas.right;
        return isAcross && bottom > canvas.top && top < canvas.bottom;
      })
      .map((element) => ({ element, text: element.textContent }));
  },
  /** Number of these values that have changed. */
  changedValues: (): { seen: number; changed: number } => ({
    seen: noted.length,
    changed: noted.filter(({ element, text }) => element.textContent !== text).length,
  }),
  hide(): void {
    isHidden = true;
    changes = 0;
    document.dispatchEvent(new Event('visibilitychange', { bubbles: true }));
    observer.observe(document, {
      subtree: true,
      childList: true,
      characterData: true,
      attributes: true,
    });
  },
  /** Updates that were pending when the page was hidden have arrived: changes count from now on. */
  settled(): void {
    observer.takeRecords();
    changes = 0;
  },
  /** @returns changes of the document that were made since then */
  show(): number {
    isHidden = false;
    const made = changes + observer.takeRecords().length;
    observer.disconnect();
    document.dispatchEvent(new Event('visibilitychange', { bubbles: true }));
    for (const callback of waiting.values()) nextFrame(callback);
    waiting.clear();
    return made;
  },
};
/** Interface for the benchmark at `window.pageWatch`. */
export type PageWatch = typeof pageWatch;

Object.assign(globalThis, { pageWatch });
