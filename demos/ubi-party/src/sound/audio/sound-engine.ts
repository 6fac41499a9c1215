import { notesOf } from '../events/notes-of.ts';
import type { SoundEvent } from '../events/sound-event.ts';
import { Playhead } from '../music/playhead.ts';
import type { Tune } from '../music/tune.ts';
import { strike, whiteNoise } from './strike.ts';

/** Timers are late; the clock of the sound card is not. Notes are given to it so far ahead. */
const AHEAD_S = 0.25;
const PULSE_MS = 60;
const MUSIC_GAIN = 0.45;
const EVENT_GAIN = 0.8;
/** Events of the same moment are heard one after the other. */
const SPREAD_S = 0.06;
/** More at a time would be noise. */
const MAX_EVENTS = 12;

/** Settings of the sound engine. */
export interface SoundWishes {
  readonly isMuted: boolean;
  readonly isMusicMuted: boolean;
  /** Nobody looks at the page. */
  readonly isHidden: boolean;
}

/** Music and sounds of a page. It makes no sound before `start`: browsers want a gesture first. */
export class SoundEngine {
  readonly #createContext: () => AudioContext;
  readonly #playhead = new Playhead();
  #desk: Desk | undefined;
  #tune: Tune | undefined;
  #timer: ReturnType<typeof setInterval> | undefined;
  #wishes: SoundWishes = { isMuted: false, isMusicMuted: false, isHidden: false };

  constructor(createContext = () => new AudioContext({ latencyHint: 'interactive' })) {
    this.#createContext = createContext;
  }

  /** Call it on a gesture; again is no harm. */
  start(): void {
    if (this.#wishes.isMuted) return;
    if (!this.#desk) {
      this.#desk = new Desk(this.#createContext());
      this.#playhead.play(this.#tune, this.#desk.context.currentTime);
      this.#timer = setInterval(() => this.#pulse(), PULSE_MS);
    }
    this.#apply();
  }

  wish(wishes: SoundWishes): void {
    this.#wishes = wishes;
    this.#apply();
  }

  /** Undefined is silence. */
  setTune(tune: Tune | undefined): void {
    this.#tune = tune;
    if (this.#desk) this.#playhead.play(tune, this.#desk.context.currentTime);
  }

  /** Sounds that nobody could hear now are left out, not kept for later. */
  play(events: readonly SoundEvent[]): void {
    const desk = this.#desk;
    if (desk?.context.state !== 'running') return;
    for (const [index, event] of events.slice(0, MAX_EVENTS).entries()) {
      for (const note of notesOf(event)) {
        const atS = desk.context.currentTime + index * SPREAD_S + note.afterS;
        strike(desk.events, desk.noise, note, atS);
      }
    }
  }

  close(): void {
    clearInterval(this.#timer);
    void this.#desk?.context.close();
    this.#desk = undefined;
  }

  #apply(): void {
    if (!this.#desk) return;
    const { context, music } = this.#desk;
    const { isMuted, isMusicMuted, isHidden } = this.#wishes;
    music.gain.value = isMusicMuted ? 0 : MUSIC_GAIN;
    // A refused resume is asked for again with the next gesture
    const changed = isMuted || isHidden ? context.suspend() : context.resume();
    changed.catch(() => undefined);
  }

  #pulse(): void {
    const desk = this.#desk;
    if (desk?.context.state !== 'running') return;
    const nowS = desk.context.currentTime;
    for (const { atS, note } of this.#playhead.take(nowS, nowS + AHEAD_S))
      strike(desk.music, desk.noise, note, atS);
  }
}

/** Two faders, and a limiter behind them. */
class Desk {
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
