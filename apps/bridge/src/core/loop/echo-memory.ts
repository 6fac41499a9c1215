import type { Clock } from '@ubii/timing';
import { BRIDGE_LIMITS } from '../limits.ts';

/**
 * Remembers what was sent to a system that sends it back, and cannot say who sent it. Each message that was sent takes away one
 * that comes. [BR-23]
 */
export class EchoMemory {
  readonly #clock: Clock;
  /** Times at which each was sent, by address and content, oldest first. */
  readonly #sent = new Map<string, number[]>();
  #count = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  handleSent(address: string, content: string): void {
    const key = `${address}\n${content}`;
    const times = this.#sent.get(key) ?? [];
    times.push(this.#clock.monotonicMs());
    // Moved to the end: the first of the map was sent longest ago.
    this.#sent.delete(key);
    this.#sent.set(key, times);
    this.#count++;
    while (this.#count > BRIDGE_LIMITS.rememberedEchoes) this.#forgetOldest();
  }

  /** Whether a message that comes is one that was sent. Each is found once. */
  takeEcho(address: string, content: string): boolean {
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

  #forgetOldest(): void {
    const [first] = this.#sent;
    if (first === undefined) return;
    const [key, times] = first;
    this.#count -= times.length;
    this.#sent.delete(key);
  }
}
