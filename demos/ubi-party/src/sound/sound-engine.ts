import { pitchOf, scalePitch, type Note, type Voice } from './note.ts';
import { Playhead, type Tune } from './playhead.ts';
import type { SoundEvent } from './sound-events.ts';
import { strike, whiteNoise } from './strike.ts';

interface LaterNote extends Note {
  readonly afterS: number;
}

/** The notes of a sound event. */
export function notesOf(event: SoundEvent): LaterNote[] {
  switch (event.kind) {
    case 'join':
      return [
        note('knock', pitchOf(event.seat), 0.8),
        note('knock', pitchOf(event.seat), 0.35, 0.16),
      ];
    case 'leave':
      return [note('knock', pitchOf(event.seat) - 12, 0.4)];
    case 'ready':
      return [note('mallet', pitchOf(event.seat), 0.35)];
    case 'hit':
      return [note('knock', pitchOf(event.seat), 0.55)];
    case 'press':
      return [note('block', pitchOf(event.seat), 0.5)];
    case 'land':
      return [note('knock', pitchOf(event.seat) - 12, 0.4)];
    case 'news':
      return [note('mallet', pitchOf(event.seat), 0.6), note('knock', pitchOf(event.seat), 0.3)];
    case 'crown':
      return run('marimba', pitchOf(event.seat), [0, 2], 0.09, 0.45);
    case 'boost':
      return run('marble', pitchOf(event.seat) + 12, [0, 1, 2, 3, 4, 5], 0.035, 0.4);
    case 'fall':
      return [
        ...run('marble', pitchOf(event.seat), [4, 3, 2, 1, 0], 0.06, 0.35),
        note('drum', 40, 0.5, 0.36),
      ];
    case 'flourish':
      return run('marimba', pitchOf(event.seat), [0, 2, 4, 5, 7, 10], 0.1, 0.75);
    case 'count':
      return [note('block', 76, 0.8)];
    case 'go':
      return [note('block', 88, 0.9), note('marimba', 72, 0.5)];
    case 'tick':
      return [note('block', event.left <= 3 ? 74 : 67, event.left <= 3 ? 0.55 : 0.16)];
    case 'ring':
      return [note('knock', 43, 0.9), note('drum', 33, 0.7, 0.05), note('knock', 38, 0.6, 0.24)];
    case 'flag':
      return [note('drum', 41, 1)];
    case 'question':
      return run('mallet', 60, [0, 3], 0.14, 0.5);
  }
}

function note(voice: Voice, midi: number, strength: number, afterS = 0): LaterNote {
  return { voice, midi, strength, afterS };
}

/** One after the other on the scale above a root. */
function run(
  voice: Voice,
  root: number,
  degrees: readonly number[],
  everyS: number,
  strength: number,
): LaterNote[] {
  return degrees.map((degree, index) =>
    note(voice, scalePitch(root, degree), strength, index * everyS),
  );
}

/** Notes are scheduled this far ahead by the audio clock: timers are late. */
const AHEAD_S = 0.25;
const PULSE_MS = 60;
const MUSIC_GAIN = 0.45;
const EVENT_GAIN = 0.8;
/** Events of the same moment are played one after the other. */
const SPREAD_S = 0.06;
/** More at once could not be distinguished. */
const MAX_EVENTS = 12;

/** Settings of the sound engine. */
interface SoundSettings {
  readonly isMuted: boolean;
  readonly isMusicMuted: boolean;
  /** The page is in the background. */
  readonly isHidden: boolean;
}

/** Music and sounds of a page. It is silent before `start`: browsers require a gesture first. */
export class SoundEngine {
  readonly #createContext: () => AudioContext;
  readonly #playhead = new Playhead();
  #mixer: Mixer | undefined;
  #tune: Tune | undefined;
  #timer: ReturnType<typeof setInterval> | undefined;
  #settings: SoundSettings = { isMuted: false, isMusicMuted: false, isHidden: false };

  constructor(createContext = () => new AudioContext({ latencyHint: 'interactive' })) {
    this.#createContext = createContext;
  }

  /** Starts the sound, on a gesture. Further calls change nothing. */
  start(): void {
    if (this.#settings.isMuted) return;
    if (!this.#mixer) {
      this.#mixer = new Mixer(this.#createContext());
      this.#playhead.play(this.#tune, this.#mixer.context.currentTime);
      this.#timer = setInterval(() => this.#pulse(), PULSE_MS);
    }
    this.#apply();
  }

  apply(settings: SoundSettings): void {
    this.#settings = settings;
    this.#apply();
  }

  /** Undefined is silence. */
  setTune(tune: Tune | undefined): void {
    this.#tune = tune;
    if (this.#mixer) this.#playhead.play(tune, this.#mixer.context.currentTime);
  }

  /** Plays events now. Without a running context they are dropped, not kept for later. */
  play(events: readonly SoundEvent[]): void {
    const mixer = this.#mixer;
    if (mixer?.context.state !== 'running') return;
    for (const [index, event] of events.slice(0, MAX_EVENTS).entries()) {
      for (const note of notesOf(event)) {
        const atS = mixer.context.currentTime + index * SPREAD_S + note.afterS;
        strike(mixer.events, mixer.noise, note, atS);
      }
    }
  }

  close(): void {
    clearInterval(this.#timer);
    void this.#mixer?.context.close();
    this.#mixer = undefined;
  }

  #apply(): void {
    if (!this.#mixer) return;
    const { context, music } = this.#mixer;
    const { isMuted, isMusicMuted, isHidden } = this.#settings;
    music.gain.value = isMusicMuted ? 0 : MUSIC_GAIN;
    // A resume that is refused is repeated with the next gesture
    const changed = isMuted || isHidden ? context.suspend() : context.resume();
    changed.catch(() => undefined);
  }

  #pulse(): void {
    const mixer = this.#mixer;
    if (mixer?.context.state !== 'running') return;
    const nowS = mixer.context.currentTime;
    for (const { atS, note } of this.#playhead.take(nowS, nowS + AHEAD_S))
      strike(mixer.music, mixer.noise, note, atS);
  }
}

/** Two gain nodes, for music and for events, with a limiter behind them. */
class Mixer {
  readonly context: AudioContext;
  readonly music: GainNode;
  readonly events: GainNode;
  readonly noise: AudioBuffer;

  constructor(context: AudioContext) {
    this.context = context;
    const limiter = new DynamicsCompressorNode(context, LIMITER);
    this.music = new GainNode(context, { gain: MUSIC_GAIN });
    this.events = new GainNode(context, { gain: EVENT_GAIN });
    for (const fader of [this.music, this.events]) fader.connect(limiter);
    limiter.connect(context.destination);
    this.noise = whiteNoise(context);
  }
}

const LIMITER = { threshold: -12, knee: 6, ratio: 12, attack: 0.003, release: 0.15 };
