/** A value on a damped spring: springs are in the party only (stiffness 180, damping 14). */
export class Spring {
  value: number;
  speed = 0;
  readonly #stiffness: number;
  readonly #damping: number;

  constructor(value: number, stiffness = 180, damping = 14) {
    this.value = value;
    this.#stiffness = stiffness;
    this.#damping = damping;
  }

  /** Goes on by a time, in parts that are short enough to be stable. */
  step(goal: number, dtS: number): number {
    const parts = Math.max(1, Math.ceil(dtS * 120));
    const part = Math.min(dtS, 0.25) / parts;
    for (let index = 0; index < parts; index += 1) {
      this.speed += ((goal - this.value) * this.#stiffness - this.speed * this.#damping) * part;
      this.value += this.speed * part;
    }
    return this.value;
  }

  /** Without motion. */
  set(value: number): void {
    this.value = value;
    this.speed = 0;
  }
}
