import { TouchEventType as TouchType, type TouchEventMessage, type Vector2 } from '@ubii/proto';

/** Number of points of a trail. */
const TRAIL_POINTS = 24;

/** A finger on the pad. */
export interface Finger {
  /** Smallest unused number, from 1. */
  readonly number: number;
  /** 0 to 1 on both axes, origin top left. */
  at: Vector2;
  /** 0 to 1; 0 when not measured. */
  force: number;
  /** Previous positions, oldest first. */
  readonly trail: Vector2[];
  /** True when it moved since the last `takeMoves`. */
  hasMoved: boolean;
}

/** Fingers on a pad; converts pointer events to touch events. */
export class Fingers {
  readonly #byPointer = new Map<number, Finger>();

  get all(): readonly Finger[] {
    return [...this.#byPointer.values()];
  }

  /** The finger that has been down longest. */
  get first(): Finger | undefined {
    return this.#byPointer.values().next().value;
  }

  has(pointerId: number): boolean {
    return this.#byPointer.has(pointerId);
  }

  start(pointerId: number, at: Vector2, force: number): TouchEventMessage {
    const taken = new Set(this.all.map(({ number }) => number));
    let number = 1;
    while (taken.has(number)) number++;
    const finger = { number, at, force, trail: [at], hasMoved: false };
    this.#byPointer.set(pointerId, finger);
    return eventOf(TouchType.TOUCH_START, finger);
  }

  /** Stores the position; `takeMoves` returns the event. */
  move(pointerId: number, at: Vector2, force: number): void {
    const finger = this.#byPointer.get(pointerId);
    if (finger === undefined) return;
    finger.at = at;
    finger.force = force;
    finger.hasMoved = true;
    finger.trail.push(at);
    if (finger.trail.length > TRAIL_POINTS) finger.trail.shift();
  }

  end(pointerId: number): TouchEventMessage | undefined {
    const finger = this.#byPointer.get(pointerId);
    if (finger === undefined) return undefined;
    this.#byPointer.delete(pointerId);
    return eventOf(TouchType.TOUCH_END, finger);
  }

  /** Lifts all fingers. */
  endAll(): TouchEventMessage[] {
    return [...this.#byPointer.keys()].flatMap((pointerId) => this.end(pointerId) ?? []);
  }

  /** Returns one event per finger that moved since the last call. */
  takeMoves(): TouchEventMessage[] {
    const moved = this.all.filter(({ hasMoved }) => hasMoved);
    for (const finger of moved) finger.hasMoved = false;
    return moved.map((finger) => eventOf(TouchType.TOUCH_MOVE, finger));
  }
}

function eventOf(
  type: TouchEventMessage['type'],
  { number, at, force }: Finger,
): TouchEventMessage {
  return { type, position: at, id: String(number), force };
}
