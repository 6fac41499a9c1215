/**
 * An original master sends a record once for each subscription that matches its topic, the copies
 * directly after each other. This leaves the first of each and tells the others apart from a value
 * that was really published again: no more frames are copies than there are subscriptions.
 */
export class ClassicDuplicates {
  #last: Uint8Array | undefined;
  #copiesLeft = 0;

  /**
   * Whether the frame is a copy of the one before.
   * @param keptFrame must not be changed later
   * @param subscriptionCount how many subscriptions at the master match its topic
   */
  isCopy(keptFrame: Uint8Array, subscriptionCount: number): boolean {
    if (this.#copiesLeft > 0 && this.#last !== undefined && isEqual(this.#last, keptFrame)) {
      this.#copiesLeft -= 1;
      return true;
    }
    this.#last = keptFrame;
    this.#copiesLeft = Math.max(0, subscriptionCount - 1);
    return false;
  }
}

function isEqual(a: Uint8Array, b: Uint8Array): boolean {
  if (a.byteLength !== b.byteLength) return false;
  for (let i = 0; i < a.byteLength; i++) if (a[i] !== b[i]) return false;
  return true;
}
