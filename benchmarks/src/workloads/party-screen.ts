import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { startBrowserCpu, IN_CHROMIUM } from '../browser/chromium.ts';
import { serveBareScreen, startScreenBrowser, type Screen } from '../party/screen-browser.ts';
import { HostedParty } from '../party/hosted-party.ts';
import type { SeenPress } from '../party/screen-watch.ts';
import { median, percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  FigureInfo,
  Measurement,
  MeasureOptions,
  Subject,
  Workload,
} from '../measuring/workload.ts';

const REFERENCE = 'bare page';
const SCREEN = 'big screen';
/** As if drawing took no time: what is left is the work of the page. */
const UNDRAWN = 'without drawing';
/** Frames are rarer than what other workloads measure. */
const LENGTH_FACTOR = 8;
/** The first frames of a scene compile shaders. */
const SETTLE_MS = 5000;
/** A press is held for two frames, and longer than a busy machine holds up the game: a page that is late gets the newest state alone. */
const HOLD_MS = 153;
const HOLD_FRAMES = 2;
const MIN_PRESSES = 8;
/** The game takes no press of a cart that is being lifted back onto the track: few presses end nowhere. */
const MAX_UNSEEN = 0.1;
const PAUSE_MS = 61;
/** Two programs read the clock of one machine. */
const CLOCK_MS = 2;

const figure = (
  key: string,
  label: string,
  unit: string,
  bounds: Readonly<Record<string, number>> = {},
): FigureInfo => ({ key, label, unit, isHigherBetter: false, goals: {}, bounds });

/** From the press of a button on a phone to the picture on the big screen, with 32 phones at 60 Hz. */
export const partyScreen: Workload = {
  name: 'party-screen',
  group: 'party-screen',
  title: 'Ubi-Party: press on a phone -> picture on the big screen in Chromium, 32 phones at 60 Hz',
  figures: [
    figure('frameP50Ms', 'frame p50', 'ms'),
    figure('frameP95Ms', 'frame p95', 'ms', { [SCREEN]: 33.4, [UNDRAWN]: 33.4 }),
    figure('pictureP50Ms', 'press -> picture p50', 'ms'),
    figure('pictureP95Ms', 'press -> picture p95', 'ms'),
    figure('arrivalP50Ms', 'press -> state at the page p50', 'ms'),
    figure('framesP50', 'state -> picture p50', 'frames', { [SCREEN]: 2, [UNDRAWN]: 2 }),
    figure('scriptMs', 'scripts a frame', 'ms'),
    figure('mainMs', 'main thread a frame', 'ms', { [UNDRAWN]: 10 }),
    figure('otherMs', 'other threads of the browser a frame', 'ms'),
    figure('masterCores', 'master CPU', 'cores'),
    figure('unseenShare', 'presses not seen', 'of all'),
  ],
  reference: REFERENCE,
  ...IN_CHROMIUM,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir }),
    );
    const browser = await parts.get('screen browser', startScreenBrowser);
    const bare = await parts.get('bare screen', serveBareScreen);
    const url = `${master.url.replace(/\/$/, '')}/party`;
    const party = await parts.get('party', () => HostedParty.open(master));
    // The round continues without a page: the bare page has the same load beside it.
    const first = await browser.open(url, false);
    await party.play();
    await first.close();
    const subject = (name: string, page: string, draws: boolean, press?: Press): Subject => ({
      name,
      pids: [master.pid],
      measure: async (options) => {
        const screen = await browser.open(page, draws);
        try {
          if (!press) await party.play();
          return await measureScreen({ master, party, screen, press }, options);
        } finally {
          await screen.close();
        }
      },
    });
    return [
      subject(SCREEN, url, true),
      subject(UNDRAWN, url, false),
      subject(REFERENCE, bare.url, true, (seat, isDown) => bare.press(seat, isDown)),
    ];
  },
};

type Press = (seat: number, isDown: boolean) => void;

interface Setting {
  readonly master: MasterProcess;
  readonly party: HostedParty;
  readonly screen: Screen;
  /** In place of the button of the phone. */
  readonly press: Press | undefined;
}

async function measureScreen(
  { master, party, screen, press }: Setting,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  await sleep(SETTLE_MS);
  const holdMs = Math.max(HOLD_MS, HOLD_FRAMES * (await frameMsOf(screen, warmUpMs)));
  const stopLap = startLap([master.pid]);
  const stopCpu = startBrowserCpu([master.pid]);
  const scriptBeganMs = await screen.scriptMs();
  await screen.start();
  const beganMs = performance.now();
  const presses = await pressInTurn(party, press, holdMs, measureMs * LENGTH_FACTOR);
  const durationMs = performance.now() - beganMs;
  const { intervalsMs, seen } = await screen.stop();
  const scriptMs = (await screen.scriptMs()) - scriptBeganMs;
  const { mainMs, otherMs } = stopCpu();
  const lap = stopLap();
  const found = presses.flatMap((pressed, index) => {
    const again = presses.slice(index + 1).find(({ seat }) => seat === pressed.seat);
    return seenOf(pressed, seen, again?.atMs ?? Infinity);
  });
  const sorted = (values: readonly number[]): Float64Array => Float64Array.from(values).sort();
  const frames = sorted(intervalsMs);
  const frameMs = percentile(frames, 0.5);
  const pictures = sorted(found.map(({ pictureMs }) => pictureMs));
  const unseen = presses.length - found.length;
  return {
    figures: {
      frameP50Ms: frameMs,
      frameP95Ms: percentile(frames, 0.95),
      pictureP50Ms: percentile(pictures, 0.5),
      pictureP95Ms: percentile(pictures, 0.95),
      arrivalP50Ms: median(found.map(({ arrivalMs }) => arrivalMs)),
      framesP50: median(found.map((one) => (one.pictureMs - one.arrivalMs) / frameMs)),
      scriptMs: scriptMs / frames.length,
      mainMs: mainMs / frames.length,
      otherMs: otherMs / frames.length,
      masterCores: lap.cpuUs / 1000 / durationMs,
      unseenShare: unseen / presses.length,
    },
    deliveries: found.length,
    otherCpuShare: Math.max(0, lap.otherCpuShare - (mainMs + otherMs) / durationMs),
    faults:
      unseen > MAX_UNSEEN * presses.length
        ? [`${unseen} of ${presses.length} presses were not seen on the page`]
        : [],
  };
}

async function frameMsOf(screen: Screen, forMs: number): Promise<number> {
  await screen.start();
  await sleep(forMs);
  return median((await screen.stop()).intervalsMs);
}

/** A press, on the clock that the page has, too. */
interface Pressed {
  readonly seat: number;
  readonly atMs: number;
}

async function pressInTurn(
  party: HostedParty,
  press: Press | undefined,
  holdMs: number,
  forMs: number,
): Promise<readonly Pressed[]> {
  const presses: Pressed[] = [];
  const endMs = performance.now() + forMs;
  while (performance.now() < endMs || presses.length < MIN_PRESSES) {
    const { seat, phone } = party.nextPhone();
    const button = (isDown: boolean): void => {
      if (press) press(seat, isDown);
      else phone.press(isDown);
    };
    presses.push({ seat, atMs: performance.timeOrigin + performance.now() });
    button(true);
    await sleep(holdMs);
    button(false);
    await sleep(PAUSE_MS);
  }
  return presses;
}

/** From the press to the state at the page, and to the picture; nothing when it was not seen before this phone pressed again. */
function seenOf(
  { seat, atMs }: Pressed,
  seen: readonly SeenPress[],
  untilMs: number,
): readonly { readonly arrivalMs: number; readonly pictureMs: number }[] {
  const found = seen.find(
    (one) => one.seat === seat && one.arrivedMs >= atMs - CLOCK_MS && one.arrivedMs < untilMs,
  );
  if (found?.drawnMs === undefined) return [];
  return [{ arrivalMs: found.arrivedMs - atMs, pictureMs: found.drawnMs - atMs }];
}
