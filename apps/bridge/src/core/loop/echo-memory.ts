import type { Clock } from '@ubii/timing';
import { BRIDGE_LIMITS } from '../limits.ts';

/**
 * Remembers what was sent to a system that sends it back, and cannot say who sent it. Each message that was sent takes away one
 * that comes. [BR-23]
 */
export class EchoMemory {
  readonly #clock: Clock;
  /** Times at which each was sent, by address and content, oldest first. The first of the map was sent longest ago. */
  readonly #sent = new Map<string, number[]>();
  #count = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Messages that may come back. */
  get size(): number {
    this.#forgetOld();
    return this.#count;
  }

  /** @param content short: it is kept */
  handleSent(address: string, content: string): void {
    this.#forgetOld();
    const key = `${address}\n${content}`;
    const times = this.#sent.get(key) ?? [];
    times.push(this.#clock.monotonicMs());
    // Moved to the end.
    this.#sent.delete(key);
    this.#sent.set(key, times);
    this.#count++;
    while (this.#count > BRIDGE_LIMITS.rememberedEchoes) this.#forgetFirst();
  }

  /** Whether a message that comes is one that was sent. Each is found once. */
  takeEcho(address: string, content: string): boolean {
    this.#forgetOld();
    const key = `${address}\n${content}`;
    const times = this.#sent.get(key);
    if (times === undefined) return false;
    const sinceMs = this.#clock.monotonicMs() - BRIDGE_LIMITS.echoMs;
    while (times.length > 0 && times[0]! < sinceMs) {
      times.shift();
      this.#count--;
    }
    const isEcho = times.shift() !== undefined;
    if (isEcho) this.#count--;
    if (times.length === 0) this.#sent.delete(key);
    return isEcho;
  }

  #forgetOld(): void {
    const sinceMs = this.#clock.monotonicMs() - BRIDGE_LIMITS.echoMs;
    for (const times of this.#sent.values()) {
      if (times.at(-1)! >= sinceMs) return;
      this.#forgetFirst();
    }
  }

  #forgetFirst(): void {
    const [first] = this.#sent;
    if (first === undefined) return;
    const [key, times] = first;
    this.#count -= times.length;
    this.#sent.delete(key);
  }
}
