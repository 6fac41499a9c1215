import { setTimeout as sleep } from 'node:timers/promises';
import { circle, type CanvasPage, type Point } from '../graph/canvas-page.ts';

/** What is done with a timeline while its frames are counted. */
export interface TimelineGesture {
  readonly key: string;
  readonly label: string;
  perform(canvas: CanvasPage, middle: Point, forMs: number): Promise<void>;
}

const WHEEL_PX = 100;
const WHEEL_MS = 16;
/** Turns of the wheel in one direction, before it goes back. */
const TURNS = 12;
const SEEK_PX = 250;

/** Turns the wheel in one direction and back. */
async function wheel({ page }: CanvasPage, forMs: number, isSideways: boolean): Promise<void> {
  const untilMs = performance.now() + forMs;
  for (let turn = 0; performance.now() < untilMs || turn % (2 * TURNS) !== TURNS; turn += 1) {
    const by = turn % (2 * TURNS) < TURNS ? -WHEEL_PX : WHEEL_PX;
    await Promise.all([
      page.mouse.wheel(isSideways ? by : 0, isSideways ? 0 : by),
      sleep(WHEEL_MS),
    ]);
  }
}

/** Each is measured for itself. All but the first are done closer, where tracks are drawn from tiles. */
export const TIMELINE_GESTURES: readonly TimelineGesture[] = [
  {
    key: 'zoom',
    label: 'zoom',
    async perform(canvas, { x, y }, forMs) {
      await canvas.page.mouse.move(x, y);
      await wheel(canvas, forMs, false);
    },
  },
  {
    key: 'pan',
    label: 'pan',
    async perform(canvas, { x, y }, forMs) {
      await canvas.page.mouse.move(x, y);
      await wheel(canvas, forMs, true);
    },
  },
  {
    key: 'seek',
    label: 'seek by dragging',
    async perform(canvas, middle, forMs) {
      const { mouse } = canvas.page;
      await mouse.move(middle.x, middle.y);
      await mouse.down();
      await circle(canvas, middle, SEEK_PX, forMs, () => Promise.resolve());
      await mouse.move(middle.x + SEEK_PX, middle.y);
      await mouse.up();
    },
  },
  {
    key: 'play',
    label: 'playing',
    async perform({ page }, _middle, forMs) {
      await page.keyboard.press('Space');
      await sleep(forMs);
      await page.keyboard.press('Space');
    },
  },
];
