import { expect, type Locator, type Page } from '@playwright/test';

/** A place on the pad: both axes 0 to 1, origin top left. */
export interface PadPosition {
  readonly x: number;
  readonly y: number;
}

/** Half a percent of the pad: positions travel through pixels. */
const PIXEL_TOLERANCE = 0.005;

/** The mouse-pointer example. */
export class MousePointerPage {
  readonly page: Page;
  readonly #hand: 'mouse' | 'finger';
  readonly pad: Locator;
  readonly ownPointer: Locator;
  readonly otherPointers: Locator;
  /** The own pointer as mirrored by the session. */
  readonly mirroredPointer: Locator;
  readonly session: Locator;
  readonly roundTrip: Locator;
  readonly hideCursor: Locator;
  readonly hideIndicator: Locator;
  readonly publishImmediately: Locator;
  readonly publishInterval: Locator;

  constructor({ page, hand = 'mouse' }: { page: Page; hand?: 'mouse' | 'finger' }) {
    this.page = page;
    this.#hand = hand;
    this.pad = page.getByRole('application', { name: 'Pointer pad' });
    this.ownPointer = page.getByTestId('own-pointer');
    this.otherPointers = page.getByTestId('other-pointer');
    this.mirroredPointer = page.getByTestId('mirrored-pointer');
    this.session = page.getByRole('region', { name: 'Session', exact: true });
    this.roundTrip = page.getByRole('region', { name: 'Round trip' });
    this.hideCursor = page.getByRole('switch', { name: 'Hide cursor' });
    this.hideIndicator = page.getByRole('switch', { name: 'Hide indicator' });
    this.publishImmediately = page.getByRole('switch', { name: /^Publish immediately/ });
    this.publishInterval = page.getByRole('slider', { name: 'Publish interval' });
  }

  async open(): Promise<void> {
    await this.page.goto('/examples/mouse-pointer');
  }

  /** Moves the mouse there. */
  async moveMouse(to: PadPosition): Promise<void> {
    const at = await this.#onScreen(to);
    await this.page.mouse.move(at.x, at.y);
  }

  /** Puts a finger down, drags it and lifts it. */
  async drag(from: PadPosition, to: PadPosition): Promise<void> {
    const touch = await this.page.context().newCDPSession(this.page);
    const send = async (type: 'touchStart' | 'touchMove' | 'touchEnd', at?: PadPosition) =>
      touch.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: at ? [await this.#onScreen(at)] : [],
      });
    await send('touchStart', from);
    const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
    for (const at of [middle, to]) await send('touchMove', at);
    await send('touchEnd');
    await touch.detach();
  }

  /** The pointer of somebody else. */
  pointerOf(name: string): Locator {
    return this.otherPointers.filter({ hasText: name });
  }

  /** Waits until a pointer is drawn at a place of the pad. */
  async expectPointer(pointer: Locator, wanted: PadPosition): Promise<void> {
    await expect
      .poll(
        async () => {
          const at = await this.positionOf(pointer);
          return at && isNear(at.x, wanted.x) && isNear(at.y, wanted.y) ? 'there' : at;
        },
        { message: `a pointer at ${wanted.x}, ${wanted.y}` },
      )
      .toBe('there');
  }

  /** Points there, with mouse or finger, and waits until the pointer is drawn where it came back. */
  async pointTo(at: PadPosition): Promise<void> {
    // The example's device may be registered only after the pad is drawn: until then moves are not sent.
    const from = { x: at.x - 0.02, y: at.y };
    await expect(async () => {
      if (this.#hand === 'finger') {
        await this.drag(from, at);
      } else {
        await this.moveMouse(from);
        await this.moveMouse(at);
      }
      await expect.poll(() => this.positionOf(this.ownPointer), { timeout: 1_000 }).toBeDefined();
    }).toPass();
    await this.expectPointer(this.ownPointer, at);
  }

  /** Moves of a mouse so fast that the page sees all of them in one turn; the last goes to `to`. */
  async moveAtOnce(moves: number, to: PadPosition): Promise<void> {
    await this.pad.evaluate(
      (pad, { moves, to }) => {
        const box = pad.getBoundingClientRect();
        for (let step = 1; step <= moves; step++) {
          const move = {
            pointerType: 'mouse',
            isPrimary: true,
            bubbles: true,
            clientX: box.left + (to.x * box.width * step) / moves,
            clientY: box.top + to.y * box.height,
          };
          pad.dispatchEvent(new PointerEvent('pointermove', move));
        }
      },
      { moves, to },
    );
  }

  /** Waits for a word about the session that mirrors the pointer. */
  async expectMirrorState(word: string): Promise<void> {
    await expect(this.session.getByRole('status')).toContainText(word);
  }

  /** Turns a switch of the session. */
  async mirror(axis: 'x' | 'y', on: boolean): Promise<void> {
    await this.session.getByRole('switch', { name: `Mirror ${axis}` }).setChecked(on);
  }

  /** Option for the node of the session's module. */
  place(name: 'Master' | 'This tab' | 'Node'): Locator {
    return this.session.getByRole('radio', { name, exact: true });
  }

  /** Moves the mouse to and fro. */
  async wiggle(): Promise<void> {
    for (const x of [0.4, 0.45, 0.5, 0.55, 0.6]) await this.moveMouse({ x, y: 0.5 });
  }

  /** Id of the client this page is. Its pointer must be drawn. */
  async ownId(): Promise<string> {
    return (await this.ownPointer.getAttribute('data-client')) ?? '';
  }

  /** A number of the round trip as it is written, such as `p50`. */
  readout(label: string): Locator {
    return this.roundTrip
      .locator('div')
      .filter({ has: this.page.getByText(label, { exact: true }) })
      .locator('dd');
  }

  /** The middle of the drawn pointer, in parts of the pad; `undefined` while it is not drawn. */
  async positionOf(pointer: Locator): Promise<PadPosition | undefined> {
    // A mark is a point without size, which is never "visible": it is drawn around by its children.
    return pointer.evaluateAll(([mark]) => {
      if (!(mark instanceof HTMLElement) || mark.hidden) return undefined;
      const pad = mark.parentElement!.getBoundingClientRect();
      const { left, top } = mark.getBoundingClientRect();
      return { x: (left - pad.left) / pad.width, y: (top - pad.top) / pad.height };
    });
  }

  async #onScreen({ x, y }: PadPosition): Promise<{ x: number; y: number }> {
    const box = await this.pad.boundingBox();
    if (!box) throw new Error('The pad is not on the page.');
    return { x: box.x + x * box.width, y: box.y + y * box.height };
  }
}

function isNear(a: number, b: number): boolean {
  return Math.abs(a - b) < PIXEL_TOLERANCE;
}
