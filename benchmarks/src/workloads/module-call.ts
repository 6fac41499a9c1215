import { IN_CHROMIUM } from '../browser/chromium.ts';
import { openBrowserPage, type BrowserPage } from '../calls-page/browser-page.ts';
import type { PagePayload, PageSubject } from '../calls-page/calls-page.ts';
import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import { bareCallee, moduleCallee, openModule } from '../calls/module-callee.ts';
import { picturePayload, RECORD_PAYLOAD, type Payload } from '../calls/payload.ts';
import { descendantPids } from '../cpu-time.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  FigureInfo,
  Subject,
  Workload,
  Measurement,
  MeasureOptions,
} from '../measuring/workload.ts';
import { startBareWorker, startNodeSandboxes } from '../modules/node-sandboxes.ts';

const REFERENCE = 'bare worker';

/** Figures of calls. */
const CALL_FIGURES: readonly FigureInfo[] = [
  { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: {} },
  { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
  {
    key: 'callingCpuUs',
    label: 'CPU a call, calling thread',
    unit: 'µs',
    isHigherBetter: false,
    goals: {},
  },
  {
    key: 'ownCpuUs',
    label: 'CPU a call, all threads',
    unit: 'µs',
    isHigherBetter: false,
    goals: {},
  },
];

/** One call of a module in Node, trusted and sandboxed, beside a message to a worker and back. */
export function moduleCall(name: string, createPayload: () => Payload): Workload {
  const { title } = createPayload();
  return {
    name: `module-call-${name}`,
    group: 'module-call',
    title: `Call of a module in Node: ${title}`,
    figures: CALL_FIGURES,
    reference: REFERENCE,
    // Only one thread has work at a time, as in the round trip.
    placement: 'one-core',
    roundShare: 1 / 3,
    open: async ({ parts }) => {
      const payload = createPayload();
      const bare = await parts.get('bare worker', startBareWorker);
      const { sandboxes } = await parts.get('sandboxes', startNodeSandboxes);
      const trusted = await openModule(sandboxes, payload, `${name} trusted`, true);
      const sandboxed = await openModule(sandboxes, payload, `${name} sandboxed`, false);
      return [
        await subject(REFERENCE, bareCallee(bare, payload)),
        await subject('trusted', moduleCallee(trusted, payload)),
        await subject('sandboxed', moduleCallee(sandboxed, payload)),
      ];
    },
  };
}

/** Both payloads. */
export const MODULE_CALLS: readonly Workload[] = [
  moduleCall('record', () => RECORD_PAYLOAD),
  moduleCall('picture', picturePayload),
];

async function subject<P, A>(name: string, callee: Callee<P, A>): Promise<Subject> {
  await warmUp(callee);
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}

const BROWSER_REFERENCE = 'bare worker';
const SUBJECTS: readonly PageSubject[] = [BROWSER_REFERENCE, 'trusted', 'sandboxed'];
/** The longest time that a call with a picture may block the page, µs. */
const MAX_HELD_US = 1000;

/** One call of a module in a page, trusted and sandboxed, beside a message to a worker and back. */
function moduleCallInBrowser(name: PagePayload, { title }: Payload): Workload {
  const bounds: Record<string, number> =
    name === 'picture' ? { trusted: MAX_HELD_US, sandboxed: MAX_HELD_US } : {};
  return {
    name: `module-call-browser-${name}`,
    group: 'module-call-browser',
    title: `Call of a module in Chromium: ${title}`,
    figures: [
      { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: {} },
      { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
      held('heldP50Us', 'page held, p50', bounds),
      held('heldP99Us', 'page held, p99', {}),
    ],
    reference: BROWSER_REFERENCE,
    ...IN_CHROMIUM,
    open: async ({ parts }) => {
      const page = await parts.get('browser page', openBrowserPage);
      return SUBJECTS.map((subject): Subject => ({
        name: subject,
        pids: [],
        measure: (options) => measureInPage(page, subject, name, options),
      }));
    },
  };
}

/** Both payloads. */
export const MODULE_CALLS_IN_BROWSER: readonly Workload[] = [
  moduleCallInBrowser('record', RECORD_PAYLOAD),
  moduleCallInBrowser('picture', picturePayload()),
];

function held(key: string, label: string, bounds: Record<string, number>): FigureInfo {
  return { key, label, unit: 'µs', isHigherBetter: false, goals: {}, bounds };
}

async function measureInPage(
  page: BrowserPage,
  subject: PageSubject,
  payload: PagePayload,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  // The browser is all that this process has started; its processes come and go.
  const stopLap = startLap(() => descendantPids(process.pid));
  const { count, faults, ...figures } = await page.measure(subject, payload, warmUpMs, measureMs);
  const { otherCpuShare } = stopLap();
  return {
    figures,
    otherCpuShare,
    deliveries: count,
    faults,
  };
}
