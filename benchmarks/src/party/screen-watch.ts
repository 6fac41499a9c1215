/**
 * Script that runs in a page before its own: notes frames, and when a state that shows a press came and was drawn.
 * The page reads a state as JSON text, and so does the bare page.
 */

/** One press, as the page saw it; milliseconds since the Unix epoch. */
export interface SeenPress {
  readonly seat: number;
  readonly arrivedMs: number;
  /** The frame after the one that draws it begins: the picture is with the browser. */
  drawnMs?: number;
}

const parse = JSON.parse;
const pressed = new Set<number>();
let seen: SeenPress[] = [];
let frames: number[] | undefined;
let watching = 0;

const nowMs = (): number => performance.timeOrigin + performance.now();

JSON.parse = (text: string, reviver?: (this: unknown, key: string, value: unknown) => unknown) => {
  const value = parse(text, reviver) as unknown;
  if (frames !== undefined) look(value);
  return value;
};

function look(value: unknown): void {
  const { carts } = (value as { state?: { carts?: unknown } } | null)?.state ?? {};
  if (!Array.isArray(carts)) return;
  for (const { seat, wasPressed } of carts as { seat: number; wasPressed: boolean }[]) {
    if (wasPressed === pressed.has(seat)) continue;
    if (!wasPressed) {
      pressed.delete(seat);
      continue;
    }
    pressed.add(seat);
    const press: SeenPress = { seat, arrivedMs: nowMs() };
    seen.push(press);
    requestAnimationFrame(() => requestAnimationFrame(() => (press.drawnMs = nowMs())));
  }
}

const nextFrame = (): Promise<number> => new Promise((resolve) => requestAnimationFrame(resolve));

async function watchFrames(): Promise<void> {
  const own = (watching += 1);
  for (;;) {
    const timeMs = await nextFrame();
    if (frames === undefined || watching !== own) return;
    frames.push(timeMs);
  }
}

const screenWatch = {
  start(): void {
    frames = [];
    seen = [];
    void watchFrames();
  },
  /** Waits for what has come to be drawn. @returns times between frames, milliseconds, and what was seen */
  async stop(): Promise<{
    readonly intervalsMs: readonly number[];
    readonly seen: readonly SeenPress[];
  }> {
    for (let count = 0; count < 3; count += 1) await nextFrame();
    const times = frames ?? [];
    frames = undefined;
    const intervalsMs = times.slice(1).map((timeMs, index) => timeMs - times[index]!);
    return { intervalsMs, seen };
  },
};
/** Interface for the benchmark at `window.screenWatch`. */
export type ScreenWatch = typeof screenWatch;

Object.assign(globalThis, { screenWatch });
