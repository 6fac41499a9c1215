import type { Note } from '../note.ts';
import { hzOf } from '../scale.ts';
import { INSTRUMENTS, type Instrument } from './instruments.ts';

/** Above it nobody hears a partial, but the sound card may. */
const MAX_HZ = 16_000;
const ATTACK_S = 0.003;
/** -80 dB: exponential ramps cannot reach 0. */
const GONE = 0.0001;

/** Plays one note at a time of the context's clock. Its nodes end by themselves. */
export function strike(out: AudioNode, noise: AudioBuffer, note: Note, atS: number): void {
  const instrument = INSTRUMENTS[note.voice];
  const peak = instrument.gain * note.strength;
  if (peak <= GONE) return;
  for (const { ratio, gain, decayS } of instrument.partials) {
    const hz = hzOf(note.midi) * ratio;
    if (hz > MAX_HZ || gain * peak <= GONE) continue;
    const tone = new OscillatorNode(out.context, { type: instrument.wave ?? 'sine' });
    bend(tone.frequency, hz, instrument.bend, atS);
    tone.connect(envelope(out, gain * peak, ATTACK_S, decayS, atS));
    tone.start(atS);
    tone.stop(atS + ATTACK_S + decayS);
  }
  if (instrument.noise) hiss(out, noise, instrument.noise, peak, atS);
}

/** One second of white noise, for the strokes. */
export function whiteNoise(context: BaseAudioContext): AudioBuffer {
  const buffer = context.createBuffer(1, context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  for (let index = 0; index < samples.length; index += 1) samples[index] = Math.random() * 2 - 1;
  return buffer;
}

function bend(frequency: AudioParam, hz: number, how: Instrument['bend'], atS: number): void {
  frequency.setValueAtTime(hz * (how?.ratio ?? 1), atS);
  if (how) frequency.exponentialRampToValueAtTime(hz, atS + how.overS);
}

function hiss(
  out: AudioNode,
  buffer: AudioBuffer,
  { filter, hz, gain, attackS, decayS }: NonNullable<Instrument['noise']>,
  peak: number,
  atS: number,
): void {
  if (gain * peak <= GONE) return;
  const source = new AudioBufferSourceNode(out.context, { buffer, loop: true });
  const tone = new BiquadFilterNode(out.context, { type: filter, frequency: hz });
  source.connect(tone).connect(envelope(out, gain * peak, attackS, decayS, atS));
  // From anywhere in the buffer: no two strokes are alike
  source.start(atS, Math.random() * buffer.duration);
  source.stop(atS + attackS + decayS);
}

function envelope(
  out: AudioNode,
  peak: number,
  attackS: number,
  decayS: number,
  atS: number,
): GainNode {
  const level = new GainNode(out.context, { gain: 0 });
  level.gain.setValueAtTime(0, atS);
  level.gain.linearRampToValueAtTime(peak, atS + attackS);
  level.gain.exponentialRampToValueAtTime(GONE, atS + attackS + decayS);
  level.connect(out);
  return level;
}
