import type { Vector3 } from '@ubii/proto';

const LONGEST_MS = 5000;
/** Attack and release, seconds: avoid clicks at start and end of a tone. */
const RAMP_S = 0.005;

let context: AudioContext | undefined;

/** Enables sound, which browsers block before a user interaction: call it in the handler of a tap. */
export function unlockSound(): void {
  context ??= new AudioContext();
  if (context.state === 'suspended') void context.resume();
}

/**
 * Plays one tone.
 *
 * @param tone x: Hz, 20 to 20 000; y: milliseconds, 5000 at most; z: volume, 0 to 1 (0 is taken as 1: not given)
 * @returns false when it is not audible: no user interaction yet, or an invalid tone
 */
export function playTone({ x: frequency, y: durationMs, z: volume }: Vector3): boolean {
  if (context === undefined || context.state !== 'running') return false;
  if (!(frequency >= 20 && frequency <= 20_000) || !(durationMs > 0)) return false;
  const seconds = Math.min(durationMs, LONGEST_MS) / 1000;
  const loudness = volume > 0 ? Math.min(volume, 1) : 1;
  const begin = context.currentTime;
  const oscillator = new OscillatorNode(context, { frequency });
  const gain = new GainNode(context, { gain: 0 });
  gain.gain.linearRampToValueAtTime(loudness, begin + RAMP_S);
  gain.gain.setValueAtTime(loudness, begin + Math.max(RAMP_S, seconds - RAMP_S));
  gain.gain.linearRampToValueAtTime(0, begin + seconds + RAMP_S);
  oscillator.connect(gain).connect(context.destination);
  oscillator.start(begin);
  oscillator.stop(begin + seconds + 2 * RAMP_S);
  return true;
}
