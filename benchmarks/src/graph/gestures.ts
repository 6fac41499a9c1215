import { setTimeout as sleep } from 'node:timers/promises';
import { circle, type CanvasPage, type Point } from './canvas-page.ts';

/** A gesture that shows another part of a graph or moves a part of it. */
export interface Gesture {
  readonly key: string;
  readonly label: string;
  /** Zoom at which it is done; undefined: as the page opened, with all nodes. */
  readonly zoom: number | undefined;
  /** @param away called once, when things are far from where they began */
  perform(
    canvas: CanvasPage,
    middle: Point,
    forMs: number,
    away: () => Promise<void>,
  ): Promise<void>;
}

const PAN_PX = 180;
const DRAG_PX = 120;
const WHEEL_PX = 100;
/** Turns of the wheel in one direction, before it goes back. */
const TURNS = 8;
const WHEEL_MS = 16;
/** Pointer position within a node, in its header, off its sockets. */
const GRIP = { x: 50, y: 12 };
/** So that the values of many nodes show: the most that there is to draw. */
const NEAR = 0.5;

const pan: Gesture['perform'] = async (canvas, middle, forMs, away) => {
  const { mouse } = canvas.page;
  await mouse.move(middle.x, middle.y);
  // The middle button pans wherever it is pressed.
  await mouse.down({ button: 'middle' });
  await circle(canvas, middle, PAN_PX, forMs, away);
  await mouse.up({ button: 'middle' });
};

const zoom: Gesture['perform'] = async (canvas, middle, forMs, away) => {
  const untilMs = performance.now() + forMs;
  for (let turn = 0; performance.now() < untilMs || turn % (2 * TURNS) !== 0; turn += 1) {
    await wheel(canvas, middle, turn % (2 * TURNS) < TURNS);
    if (turn === TURNS - 1) await away();
  }
};

const drag: Gesture['perform'] = async (canvas, middle, forMs, away) => {
  const { mouse } = canvas.page;
  const place = await canvas.watch('place', await canvas.watch('nodeNear', middle.x, middle.y));
  const grip = { x: place.x + GRIP.x * place.scale, y: place.y + GRIP.y * place.scale };
  await mouse.move(grip.x, grip.y);
  await mouse.down();
  await circle(canvas, grip, DRAG_PX, forMs, away);
  await mouse.up();
};

/** Each is measured for itself. */
export const GESTURES: readonly Gesture[] = [
  { key: 'panAll', label: 'pan all nodes', zoom: undefined, perform: pan },
  { key: 'zoom', label: 'zoom', zoom: undefined, perform: zoom },
  { key: 'pan', label: 'pan at 50 %', zoom: NEAR, perform: pan },
  { key: 'drag', label: 'drag a node', zoom: NEAR, perform: drag },
];

async function wheel({ page }: CanvasPage, { x, y }: Point, isIn: boolean): Promise<void> {
  await page.mouse.move(x, y);
  await Promise.all([page.mouse.wheel(0, isIn ? -WHEEL_PX : WHEEL_PX), sleep(WHEEL_MS)]);
}

/** Turns the wheel until things are at least so large. */
export async function zoomIn(canvas: CanvasPage, middle: Point, scale: number): Promise<void> {
  const node = await canvas.watch('nodeNear', middle.x, middle.y);
  while ((await canvas.watch('place', node)).scale < scale) await wheel(canvas, middle, true);
}
