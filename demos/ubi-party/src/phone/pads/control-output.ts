import type { PhoneLink } from '../../net/phone/phone-link.ts';
import { STRAIGHT, type Steering } from './stick.ts';

/** Sources of steering, the highest priority first. A hand on the pad always wins over continuous sources. */
const STEERERS = ['thumb', 'keys', 'gamepad', 'one-button', 'tilt'] as const;
export type Steerer = (typeof STEERERS)[number];
export const PRESSERS = ['pad', 'keys', 'gamepad'] as const;
export type Presser = (typeof PRESSERS)[number];

/** Finer than the eye sees; a sensor's noise below it is not sent. */
const STEPS = 100;

/**
 * Brings all that steers and presses together. A press goes out at once, since its time counts; steering goes out
 * with `frame`, once per animation frame and only when it has changed.
 */
export class ControlOutput {
  readonly #link: Pick<PhoneLink, 'steer' | 'press'>;
  readonly #steering = new Map<Steerer, Steering>();
  readonly #pressing = new Set<Presser>();
  #sent = STRAIGHT;
  #isPressSent = false;

  constructor(link: Pick<PhoneLink, 'steer' | 'press'>) {
    this.#link = link;
  }

  /** @param steering undefined: this one does not steer now */
  steer(by: Steerer, steering: Steering | undefined): void {
    if (steering) this.#steering.set(by, steering);
    else this.#steering.delete(by);
  }

  /** @returns whether the button went down or up by this */
  press(by: Presser, isDown: boolean): boolean {
    if (isDown) this.#pressing.add(by);
    else this.#pressing.delete(by);
    const isPressed = this.#pressing.size > 0;
    if (isPressed === this.#isPressSent) return false;
    this.#isPressSent = isPressed;
    this.#link.press(isPressed);
    return true;
  }

  /** Sends what has changed. @returns what is sent */
  frame(): Steering {
    const { x, y } = this.#strongest();
    const next = { x: rounded(x), y: rounded(y) };
    if (next.x !== this.#sent.x || next.y !== this.#sent.y) {
      this.#sent = next;
      this.#link.steer(next.x, next.y);
    }
    return this.#sent;
  }

  /** Releases all inputs, such as when the page is hidden. */
  release(): void {
    this.#steering.clear();
    this.#pressing.clear();
    if (this.#isPressSent) this.#link.press(false);
    this.#isPressSent = false;
    this.frame();
  }

  #strongest(): Steering {
    for (const steerer of STEERERS) {
      const steering = this.#steering.get(steerer);
      if (steering) return steering;
    }
    return STRAIGHT;
  }
}

/** Without -0, which is not 0 on the wire. */
function rounded(value: number): number {
  return Math.round(value * STEPS) / STEPS + 0;
}
