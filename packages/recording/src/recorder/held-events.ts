import { stateKey, type RecordingEvent } from '../records/recording-event.ts';

interface HeldEvent {
  readonly event: RecordingEvent;
  /** Time by which it leaves the window. */
  readonly atNs: bigint;
  readonly bytes: number;
}

/** The events of the window, and the last states of sessions, clients, devices and clocks before it. */
export class HeldEvents {
  readonly #window: HeldEvent[] = [];
  readonly #before = new Map<string, HeldEvent>();
  #bytes = 0;

  get bytes(): number {
    return this.#bytes;
  }

  /** The first of the window; undefined when there is none. */
  get oldestNs(): bigint | undefined {
    return this.#window[0]?.atNs;
  }

  /** @param atNs by which it leaves the window */
  add(event: RecordingEvent, atNs: bigint): void {
    const bytes = 256 + 2 * JSON.stringify(event.value).length;
    this.#window.push({ event, atNs, bytes });
    this.#bytes += bytes;
  }

  /** Lets events leave the window that were added before the first one that is not earlier than a moment. */
  expire(beforeNs: bigint): void {
    while (this.#window.length > 0 && this.#window[0]!.atNs < beforeNs) this.#expireFirst();
  }

  /** Forgets the oldest: of the window first, as states before it may still apply. */
  limit(maxBytes: number): void {
    while (this.#bytes > maxBytes && this.#window.length > 0) this.#expireFirst();
    for (const key of this.#before.keys()) {
      if (this.#bytes <= maxBytes) return;
      this.#forget(key);
    }
  }

  /** The states before the window, then the events in it. */
  *[Symbol.iterator](): Generator<RecordingEvent> {
    for (const { event } of this.#before.values()) yield event;
    for (const { event } of this.#window) yield event;
  }

  #expireFirst(): void {
    const held = this.#window.shift()!;
    const key = stateKey(held.event);
    if (key === undefined) this.#bytes -= held.bytes;
    else {
      this.#forget(key);
      if (isOver(held.event)) this.#bytes -= held.bytes;
      else this.#before.set(key, held);
    }
  }

  #forget(key: string): void {
    this.#bytes -= this.#before.get(key)?.bytes ?? 0;
    this.#before.delete(key);
  }
}

/** Whether nothing applies any more: devices come and go without end. */
function isOver({ kind, value }: RecordingEvent): boolean {
  return kind === 'device' && value.state === 'deregistered';
}
