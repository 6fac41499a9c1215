import { describe, expect, it } from 'vitest';
import { RateMeter } from '../../sensors/rate-meter.ts';
import type { PictureSettings } from '../encode-picture.ts';
import { adaptationWords } from './adaptation-words.ts';
import { adaptedStep, adaptPictures, FIRST_STATE, type AdaptState } from './adapt-pictures.ts';
import { stepCost, type PictureStep } from './picture-ladder.ts';
import { PictureMeter } from './picture-meter.ts';

const WANTED: PictureSettings = { width: 640, rateHz: 30, encoding: 'JPEG', quality: 0.8 };
/** Size of a picture with the wanted settings, bytes. */
const PICTURE_BYTES = 60_000;
const BYTES_PER_COST = PICTURE_BYTES / stepCost({ ...WANTED, rateHz: 1 });
const DECIDE_MS = 500;

interface World {
  /** Capacity of the network at a time, bytes per second. */
  readonly linkAt?: (ms: number) => number;
  /** Size of the operating system's send buffer, bytes. */
  readonly systemBytes?: number;
  /** Rate at which modules process pictures, Hz; default: no results. */
  readonly moduleAt?: (ms: number) => number;
  /** Measured rate of results. */
  readonly countedAs?: (hz: number) => number;
  /** Counts results one by one, like pages do. */
  readonly isCounted?: boolean;
  readonly encodeMs?: number;
  readonly wanted?: PictureSettings;
}

/** Simulates a page that sends pictures over a network, in steps of a millisecond. Returns its decisions. */
function simulate(seconds: number, world: World) {
  const { linkAt = () => 50e6, systemBytes = 0, moduleAt, encodeMs = 5, wanted = WANTED } = world;
  const { countedAs = (hz: number) => hz, isCounted = false } = world;
  const meter = new PictureMeter();
  const results = new RateMeter(5000);
  let lastResultMs = 0;
  let state: AdaptState = FIRST_STATE;
  let inPage = 0;
  let inSystem = 0;
  let underway: { atMs: number; bytes: number } | undefined;
  let nextMs = 0;
  let maxInPage = 0;
  let sentHz = 0;
  const roundTripsMs = [5];
  const steps: { ms: number; step: PictureStep; state: AdaptState; sentHz: number }[] = [];
  const delays: number[] = [];
  for (let ms = 0; ms < seconds * 1000; ms++) {
    const step = adaptedStep(state, wanted);
    // The network drains the system's buffer, which drains the page's.
    inSystem = Math.max(0, inSystem - linkAt(ms) / 1000);
    const moved = Math.min(inPage, Math.max(0, systemBytes + linkAt(ms) / 1000 - inSystem));
    inPage -= moved;
    inSystem += moved;
    if (underway !== undefined && inPage < 1) {
      const { atMs, bytes } = underway;
      meter.note({ atMs, bytes, encodeMs, leaveMs: ms - atMs });
      delays.push(ms - atMs + (inSystem / linkAt(ms)) * 1000);
      underway = undefined;
      if (moduleAt !== undefined && ms - lastResultMs >= 1000 / moduleAt(ms)) {
        results.note((lastResultMs = ms));
      }
    }
    if (underway === undefined && ms >= nextMs) {
      const bytes = BYTES_PER_COST * stepCost({ ...step, rateHz: 1 });
      underway = { atMs: ms, bytes };
      inPage += bytes;
      nextMs = ms + 1000 / step.rateHz;
    }
    maxInPage = Math.max(maxInPage, inPage);
    if (ms % DECIDE_MS !== 0) continue;
    const sent = meter.summary();
    sentHz = sent?.rateHz ?? sentHz;
    const idealHz =
      moduleAt === undefined ? undefined : countedAs(Math.min(moduleAt(ms), sent?.rateHz ?? 0));
    const resultHz = isCounted ? results.rateHz(ms) : idealHz;
    if (ms % 2000 === 0) roundTripsMs.push(5 + (inSystem / linkAt(ms)) * 1000);
    state = adaptPictures(state, wanted, {
      nowMs: ms,
      sent,
      roundTripsMs,
      resultHz,
    });
    const after = adaptedStep(state, wanted);
    const isOther = after.width !== step.width || after.quality !== step.quality;
    if (isOther) meter.clear();
    steps.push({ ms, step: after, state, sentHz });
  }
  const after = (fromMs: number) => steps.filter(({ ms }) => ms >= fromMs);
  /** Number of changes of the sent settings. */
  const changes = (fromMs: number): number =>
    after(fromMs).filter(({ step, ms }, index, all) => {
      const before = all[index - 1]?.step ?? step;
      return ms > fromMs && (before.width !== step.width || before.quality !== step.quality);
    }).length;
  return { steps, after, changes, delays, maxInPage, last: steps.at(-1)! };
}

describe('the controller of pictures', () => {
  it('sends what is wanted as long as nothing speaks against it', () => {
    const { steps } = simulate(20, {});
    for (const { step } of steps) expect(step).toEqual({ width: 640, quality: 0.8, rateHz: 30 });
  });

  it.each([
    ['a slow Wi-Fi', 600_000, 0],
    ['a slow Wi-Fi behind a queue of the system', 600_000, 400_000],
    ['a very slow one', 150_000, 100_000],
  ])('comes down to what %s takes within 15 s, and stays there', (_what, link, systemBytes) => {
    const { after, changes, delays, maxInPage } = simulate(120, {
      linkAt: () => link,
      systemBytes,
    });
    for (const { step } of after(15_000)) {
      expect(BYTES_PER_COST * stepCost(step)).toBeLessThan(1.9 * link);
      // Does not reduce more than necessary.
      expect(BYTES_PER_COST * stepCost(step)).toBeGreaterThan(0.25 * link);
    }
    // Tries to increase by one level, and back, at growing intervals: after 15, 30 and 60 s.
    expect(changes(20_000)).toBeLessThanOrEqual(8);
    expect(changes(90_000)).toBeLessThanOrEqual(3);
    expect(maxInPage).toBeLessThanOrEqual(PICTURE_BYTES);
    const late = delays.slice(-200).sort((a, b) => a - b);
    expect(late[100]).toBeLessThan(300);
  });

  it('comes back from 2 Hz, although one result of a window is often missing', () => {
    let count = 0;
    const state = { ...FIRST_STATE, moduleHz: 2.4, resultHz: 2.1 };
    const sentOf = (rateHz: number) => ({
      bytes: 30_000,
      encodeMs: 10,
      leaveMs: 4,
      rateHz,
      bytesPerSecond: 30_000 * rateHz,
    });
    let now: AdaptState = state;
    for (let ms = 0; ms < 60_000; ms += DECIDE_MS) {
      const { rateHz } = adaptedStep(now, WANTED);
      // Counted over two to three seconds, with one result more or less.
      const resultHz = rateHz - ((count += 1) % 3 === 0 ? 0 : 0.45);
      const sent = sentOf(rateHz);
      now = adaptPictures(now, WANTED, { nowMs: ms, sent, roundTripsMs: [5], resultHz });
    }
    expect(adaptedStep(now, WANTED).rateHz).toBeGreaterThan(15);
  });

  it('takes no short queue for a slow link where pictures are few', () => {
    const sent = { bytes: 3000, encodeMs: 5, leaveMs: 4, rateHz: 1, bytesPerSecond: 3000 };
    const slow = { ...FIRST_STATE, moduleHz: 1, resultHz: 1 };
    const decide = (roundTripsMs: number[]) =>
      adaptPictures(slow, WANTED, { nowMs: 10_000, sent, roundTripsMs, resultHz: 1 }).level;
    expect(decide([5, 400, 400])).toBe(0);
    expect(decide([5, 900, 900])).toBeGreaterThan(0);
  });

  it('lowers quality first, then size, then rate', () => {
    const { steps } = simulate(60, { linkAt: () => 30_000 });
    const of = (fits: (step: PictureStep) => boolean) => steps.findIndex(({ step }) => fits(step));
    const [quality, width, rate] = [
      of((step) => step.quality < 0.8),
      of((step) => step.width < 640),
      of((step) => step.rateHz < 30),
    ];
    expect(quality).toBeLessThanOrEqual(width!);
    expect(width).toBeLessThan(rate!);
    expect(steps.at(-1)!.step).toMatchObject({ width: 160, quality: 0.5 });
  });

  it('takes a stall of 2 s for what it is', () => {
    const linkAt = (ms: number) => (ms >= 10_000 && ms < 12_000 ? 1 : 6e6);
    const { after, maxInPage } = simulate(30, { linkAt });
    for (const { step } of after(0)) expect(step).toMatchObject({ width: 640, quality: 0.8 });
    expect(maxInPage).toBeLessThanOrEqual(PICTURE_BYTES);
  });

  it('follows a module that takes 4 pictures a second, with the rate alone, and steadily', () => {
    const { after } = simulate(60, { moduleAt: () => 4 });
    for (const { step } of after(10_000)) {
      expect(step).toMatchObject({ width: 640, quality: 0.8 });
      expect(step.rateHz).toBeGreaterThanOrEqual(4);
      expect(step.rateHz).toBeLessThan(5);
    }
    const rates = after(20_000).map(({ step }) => step.rateHz);
    expect(Math.max(...rates) - Math.min(...rates)).toBeLessThan(0.5);
  });

  it('comes back from a module that was held up, though the few results since say little', () => {
    // At low rates, one result is often missing at the moment of the decision.
    const countedAs = (hz: number): number => (hz < 1.5 ? hz * 0.8 : hz);
    const moduleAt = (ms: number): number => (ms < 20_000 ? 0.3 : 4);
    const { after } = simulate(70, { moduleAt, countedAs });
    const rates = after(40_000).map(({ step }) => step.rateHz);
    expect(Math.min(...rates)).toBeGreaterThan(2);
  });

  it('comes back within seconds when a module that was slow is quick again, by the results as they are counted', () => {
    const moduleAt = (ms: number): number => (ms < 30_000 ? 1.5 : 15);
    const { after } = simulate(60, { moduleAt, isCounted: true });
    const rates = after(42_000).map(({ step }) => step.rateHz);
    expect(Math.min(...rates)).toBeGreaterThan(8);
  });

  it('comes back to what is wanted when link and module have recovered', () => {
    const { last, after } = simulate(120, {
      linkAt: (ms) => (ms < 20_000 ? 300_000 : 20e6),
      moduleAt: (ms) => (ms < 40_000 ? 4 : 60),
    });
    expect(last.step).toEqual({ width: 640, quality: 0.8, rateHz: 30 });
    expect(after(90_000).every(({ step }) => step.rateHz === 30)).toBe(true);
  });

  it('leaves a slow device time for other things than encoding', () => {
    const { last } = simulate(20, { encodeMs: 60 });
    expect(last.step).toMatchObject({ width: 640, quality: 0.8, rateHz: 10 });
  });

  it('never sends more than is wanted, also when less is wanted than before', () => {
    const { last } = simulate(30, { linkAt: () => 100_000 });
    const less: PictureSettings = { width: 160, rateHz: 1, encoding: 'RGB8', quality: 0.7 };
    expect(adaptedStep(last.state, less)).toEqual({ width: 160, quality: 0.7, rateHz: 1 });
    expect(adaptPictures(last.state, less, { nowMs: 31_000, sent: undefined }).level).toBe(0);
  });
});

describe('what is said of it', () => {
  const state = { ...FIRST_STATE, linkBytesPerSecond: 1_200_000 };

  it('names what was changed, and why', () => {
    expect(adaptationWords(FIRST_STATE, WANTED)).toBeUndefined();
    expect(adaptationWords({ ...state, level: 3 }, WANTED)).toBe(
      '640 → 480 px, quality 80 → 50 %, because 1.2 MB/s reach the master.',
    );
    const raw: PictureSettings = { ...WANTED, encoding: 'RGB8' };
    expect(adaptationWords({ ...state, level: 1 }, raw)).toBe(
      '640 → 480 px, because 1.2 MB/s reach the master.',
    );
  });

  it('tells modules from this device', () => {
    const module = { ...FIRST_STATE, moduleHz: 4.4, resultHz: 4, deviceHz: 100, encodeMs: 6 };
    expect(adaptationWords(module, WANTED)).toBe(
      '30 → 4 Hz, because modules process 4 pictures per second.',
    );
    expect(adaptationWords({ ...FIRST_STATE, deviceHz: 10, encodeMs: 60 }, WANTED)).toBe(
      '30 → 10 Hz, because this device encodes slowly.',
    );
    expect(adaptationWords({ ...module, linkBytesPerSecond: 5e5, level: 3 }, WANTED)).toBe(
      '640 → 480 px, quality 80 → 50 %, because 500 kB/s reach the master; 30 → 4 Hz, because modules process 4 pictures per second.',
    );
  });

  it('tells rates as they are, and what pictures wait for', () => {
    const sent = { bytes: 20_000, encodeMs: 5, leaveMs: 4, rateHz: 2.4, bytesPerSecond: 48_000 };
    const slow = { ...FIRST_STATE, deviceHz: 6, encodeMs: 100 };
    expect(adaptationWords(slow, WANTED, sent)).toBe('30 → 2.4 Hz, because this device is busy.');
    expect(adaptationWords(slow, WANTED, { ...sent, rateHz: 5.5 })).toBe(
      '30 → 6 Hz, because this device encodes slowly.',
    );
    expect(adaptationWords(FIRST_STATE, WANTED, { ...sent, leaveMs: 350 })).toBe(
      '30 → 2.4 Hz, because 48 kB/s reach the master.',
    );
    expect(adaptationWords(FIRST_STATE, WANTED, { ...sent, rateHz: 28 })).toBeUndefined();
  });
});
