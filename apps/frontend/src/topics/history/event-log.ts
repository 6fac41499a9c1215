import {
  ButtonEventType,
  HandGestureType,
  ModuleEventKind,
  TouchEventType,
  type TopicRecord,
  type TouchEventMessage,
} from '@ubii/proto';

/** An event. */
export interface EventEntry {
  /** Sequence number, from 1. */
  readonly number: number;
  /** This computer's clock. */
  readonly timeMs: number;
  /** Key, button, finger, gesture or module. */
  readonly name: string;
  readonly action: string;
  /** Details, such as a position; may be empty. */
  readonly detail: string;
  /** Number of merged events: consecutive moves of one finger are one entry. */
  readonly times: number;
}

/** Statistics of one key, button, finger, gesture or module. */
export interface EventTally {
  readonly name: string;
  readonly isDown: boolean;
  /** Number of presses, touches, or other events. */
  readonly downs: number;
  readonly ups: number;
  readonly lastMs: number;
  /**
   * Intervals of being pressed, oldest first; the last one is open while pressed. Events without a duration have zero
   * length.
   */
  readonly spans: readonly { readonly fromMs: number; readonly toMs: number | undefined }[];
}

/** Position of a finger, or where it was lifted. */
export interface Finger {
  readonly id: string;
  readonly x: number;
  readonly y: number;
  readonly isGone: boolean;
  readonly timeMs: number;
}

export const MAX_ENTRIES = 200;
const MAX_NAMES = 60;
const MAX_SPANS = 60;
const MAX_FINGERS = 20;

type Kind = 'down' | 'up' | 'moment' | 'move';
interface Happening {
  readonly name: string;
  readonly kind: Kind;
  readonly action: string;
  readonly detail?: string;
}

interface Tally {
  name: string;
  isDown: boolean;
  downs: number;
  ups: number;
  lastMs: number;
  spans: { fromMs: number; toMs: number | undefined }[];
}

const nameOf = (names: Readonly<Record<string, number>>, value: number): string =>
  Object.keys(names)
    .find((key) => names[key] === value)
    ?.toLowerCase()
    .replaceAll('_', ' ') ?? String(value);

/** Data formats whose records are events. */
export const EVENT_FORMATS: ReadonlySet<string> = new Set<TopicRecord['format']>([
  'bool',
  'keyEvent',
  'mouseEvent',
  'touchEvent',
  'touchEventList',
  'myoEvent',
  'moduleEvent',
]);

/** Events on a topic since it was opened: tallies of all, and the newest as a list. Bounded. */
export class EventLog {
  readonly #entries: EventEntry[] = [];
  readonly #tallies = new Map<string, Tally>();
  readonly #fingers = new Map<string, Finger>();
  #count = 0;
  #last: string | undefined;

  /** Number of all events, with each move. */
  get count(): number {
    return this.#count;
  }

  /** Newest first. */
  get entries(): readonly EventEntry[] {
    return [...this.#entries].reverse();
  }

  /** Most recent first. */
  get tallies(): readonly EventTally[] {
    return [...this.#tallies.values()]
      .map((tally) => ({ ...tally, spans: [...tally.spans] }))
      .sort((a, b) => b.lastMs - a.lastMs || (a.name < b.name ? -1 : 1));
  }

  get fingers(): readonly Finger[] {
    return [...this.#fingers.values()];
  }

  /** @param timeMs this computer's clock */
  add(record: TopicRecord, timeMs: number): void {
    const { format, value } = record;
    if (format === 'touchEvent') this.#touch(value, timeMs);
    else if (format === 'touchEventList') {
      for (const element of value.elements) this.#touch(element, timeMs);
    } else {
      const happening = this.#read(record, timeMs);
      if (happening) this.#happen(happening, timeMs);
    }
  }

  #read(record: TopicRecord, timeMs: number): Happening | undefined {
    const { format, value } = record;
    switch (format) {
      case 'keyEvent': {
        const kind = value.type === ButtonEventType.DOWN ? 'down' : 'up';
        const name = value.key === ' ' ? 'Space' : value.key || '(no key)';
        return { name, kind, action: kind };
      }
      case 'mouseEvent': {
        const kind = value.type === ButtonEventType.DOWN ? 'down' : 'up';
        return { name: `button ${value.button}`, kind, action: kind };
      }
      case 'bool': {
        const action = String(value);
        if (this.#last === action) return undefined;
        this.#last = action;
        return { name: 'true', kind: value ? 'down' : 'up', action };
      }
      case 'myoEvent': {
        const gesture = nameOf(HandGestureType, value.gesture);
        if (this.#last === gesture) return undefined;
        if (this.#last !== undefined) this.#close(this.#last, timeMs);
        this.#last = gesture;
        return { name: gesture, kind: 'down', action: 'begins' };
      }
      case 'moduleEvent':
        return {
          name: value.moduleName || value.moduleId || 'module',
          kind: 'moment',
          action: nameOf(ModuleEventKind, value.kind),
          detail: value.message,
        };
      default:
        return undefined;
    }
  }

  #touch({ id, type, position, force }: TouchEventMessage, timeMs: number): void {
    const name = `finger ${id || '?'}`;
    const isGone = type === TouchEventType.TOUCH_END;
    const before = this.#fingers.get(name);
    const { x, y } = position ?? before ?? { x: 0, y: 0 };
    this.#fingers.delete(name);
    this.#fingers.set(name, { id, x, y, isGone, timeMs });
    for (const old of this.#fingers.keys()) {
      if (this.#fingers.size <= MAX_FINGERS) break;
      this.#fingers.delete(old);
    }
    const kind: Kind = type === TouchEventType.TOUCH_START ? 'down' : isGone ? 'up' : 'move';
    const pressed = force > 0 ? `, force ${force.toFixed(2)}` : '';
    const detail = `${x.toFixed(3)}, ${y.toFixed(3)}${pressed}`;
    const action = { down: 'start', up: 'end', move: 'move', moment: '' }[kind];
    this.#happen({ name, kind, action, detail }, timeMs);
  }

  #happen({ name, kind, action, detail = '' }: Happening, timeMs: number): void {
    this.#count += 1;
    const at = kind === 'move' ? this.#lastMoveOf(name) : -1;
    const last = this.#entries[at];
    if (last) this.#entries[at] = { ...last, timeMs, detail, times: last.times + 1 };
    else {
      this.#entries.push({ number: this.#count, timeMs, name, action, detail, times: 1 });
      if (this.#entries.length > MAX_ENTRIES) this.#entries.shift();
    }
    const tally = this.#tallyOf(name);
    tally.lastMs = timeMs;
    if (kind === 'down' || kind === 'move') {
      if (kind === 'down') tally.downs += 1;
      // Key repeats and finger moves imply a press: start the interval now if that event was missed.
      if (!tally.isDown) tally.spans.push({ fromMs: timeMs, toMs: undefined });
      tally.isDown = true;
    } else if (kind === 'up') {
      tally.ups += 1;
      this.#close(name, timeMs);
    } else if (kind === 'moment') {
      tally.downs += 1;
      tally.spans.push({ fromMs: timeMs, toMs: timeMs });
    }
    if (tally.spans.length > MAX_SPANS) tally.spans.shift();
  }

  #close(name: string, timeMs: number): void {
    const tally = this.#tallies.get(name);
    const open = tally?.spans.at(-1);
    if (!tally) return;
    if (open && open.toMs === undefined) open.toMs = timeMs;
    tally.isDown = false;
  }

  /** Events of several fingers alternate: the last entry of this one may be further back. */
  #lastMoveOf(name: string): number {
    const at = this.#entries.findLastIndex((entry) => entry.name === name);
    const isNear = at >= this.#entries.length - MAX_FINGERS;
    return isNear && this.#entries[at]?.action === 'move' ? at : -1;
  }

  #tallyOf(name: string): Tally {
    let tally = this.#tallies.get(name);
    if (!tally) {
      tally = { name, isDown: false, downs: 0, ups: 0, lastMs: 0, spans: [] };
      this.#tallies.set(name, tally);
      if (this.#tallies.size > MAX_NAMES) this.#forgetOldest(name);
    }
    return tally;
  }

  #forgetOldest(except: string): void {
    const [oldest] = [...this.#tallies.values()]
      .filter(({ name }) => name !== except)
      .sort((a, b) => a.lastMs - b.lastMs);
    if (oldest) this.#tallies.delete(oldest.name);
  }
}
