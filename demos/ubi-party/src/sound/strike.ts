import { hzOf, type Voice, type Note } from './note.ts';

/** Sound of a struck instrument: decaying tones, and the noise of the stroke. */
interface Instrument {
  readonly gain: number;
  readonly wave?: OscillatorType;
  /** Frequency as a multiple of the pitch, share of the gain, and seconds until it is gone. */
  readonly partials: readonly {
    readonly ratio: number;
    readonly gain: number;
    readonly decayS: number;
  }[];
  /** The pitch begins so many times higher, as that of a drum does, and falls within `overS`. */
  readonly bend?: { readonly ratio: number; readonly overS: number };
  readonly noise?: {
    readonly filter: 'lowpass' | 'bandpass' | 'highpass';
    readonly hz: number;
    readonly gain: number;
    readonly attackS: number;
    readonly decayS: number;
  };
}

const partial = (ratio: number, gain: number, decayS: number) => ({ ratio, gain, decayS });
const click = (hz: number, gain: number, decayS = 0.02) =>
  ({ filter: 'bandpass', hz, gain, attackS: 0.001, decayS }) as const;

/**
 * Bars of marimbas are tuned to 1 : 4 : 10 (Fletcher and Rossing, The Physics of Musical Instruments, 19.2); free bars
 * of wood have 1 : 2.76 : 5.4 (18.3), round membranes 1 : 1.59 (3.2).
 */
const INSTRUMENTS: Readonly<Record<Voice, Instrument>> = {
  marimba: {
    gain: 0.5,
    partials: [partial(1, 1, 0.9), partial(4, 0.22, 0.22), partial(10, 0.06, 0.07)],
    noise: click(900, 0.12),
  },
  bass: {
    gain: 0.75,
    wave: 'triangle',
    partials: [partial(1, 0.9, 0.7), partial(2, 0.25, 0.3), partial(3, 0.08, 0.12)],
    noise: click(500, 0.12, 0.03),
  },
  brush: {
    gain: 0.35,
    partials: [],
    noise: { filter: 'highpass', hz: 3500, gain: 0.5, attackS: 0.02, decayS: 0.16 },
  },
  felt: {
    gain: 0.9,
    partials: [partial(1, 1, 0.38), partial(1.59, 0.3, 0.16)],
    bend: { ratio: 1.5, overS: 0.06 },
    noise: { filter: 'lowpass', hz: 500, gain: 0.35, attackS: 0.004, decayS: 0.06 },
  },
  shaker: {
    gain: 0.3,
    partials: [],
    noise: { filter: 'highpass', hz: 6000, gain: 0.6, attackS: 0.015, decayS: 0.07 },
  },
  clock: {
    gain: 0.3,
    partials: [partial(1, 0.8, 0.05), partial(2.76, 0.5, 0.03)],
    noise: click(4000, 0.3, 0.01),
  },
  block: {
    gain: 0.55,
    partials: [partial(1, 1, 0.13), partial(2.76, 0.4, 0.06)],
    noise: click(1800, 0.3),
  },
  knock: {
    gain: 0.6,
    partials: [partial(1, 1, 0.2), partial(2.76, 0.35, 0.08), partial(5.4, 0.15, 0.03)],
    noise: click(1200, 0.5, 0.03),
  },
  mallet: {
    gain: 0.5,
    partials: [partial(1, 1, 0.6), partial(2, 0.12, 0.2)],
    noise: { filter: 'lowpass', hz: 600, gain: 0.15, attackS: 0.006, decayS: 0.05 },
  },
  marble: {
    gain: 0.3,
    partials: [partial(2, 0.7, 0.06), partial(5.4, 0.4, 0.03)],
    noise: click(5000, 0.35, 0.012),
  },
  drum: {
    gain: 1,
    partials: [partial(1, 1, 0.7), partial(1.59, 0.4, 0.3), partial(2.3, 0.2, 0.15)],
    bend: { ratio: 1.8, overS: 0.08 },
    noise: { filter: 'lowpass', hz: 1200, gain: 0.5, attackS: 0.002, decayS: 0.09 },
  },
};

/** Partials above it are not audible. */
const MAX_HZ = 16_000;
const ATTACK_S = 0.003;
/** -80 dB: exponential ramps cannot reach 0. */
const GONE = 0.0001;

/** Plays one note at a time of the context's clock. Its nodes stop on their own. */
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
