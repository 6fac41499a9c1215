/** Duration of a simulated movement, milliseconds, and its number of positions. */
const DURATION_MS = 1_600;
const POSITIONS = 60;

/** Moves the pointer of this page in a circle, like a user. */
export async function movePointer(): Promise<void> {
  for (let step = 0; step <= POSITIONS; step += 1) {
    const angle = (2 * Math.PI * step) / POSITIONS;
    const event = new PointerEvent('pointermove', {
      bubbles: true,
      isPrimary: true,
      clientX: innerWidth * (0.3 + 0.2 * Math.cos(angle)),
      clientY: innerHeight * (0.5 + 0.3 * Math.sin(angle)),
    });
    window.dispatchEvent(event);
    await new Promise((resolve) => setTimeout(resolve, DURATION_MS / POSITIONS));
  }
}
