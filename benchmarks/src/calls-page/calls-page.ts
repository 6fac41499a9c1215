/** Script of the page: calls modules in the sandboxes of browsers, and a bare worker, on request. */
import { createBrowserSandboxes } from '@ubii/pm-sandbox/browser';
import { CallSeries, type Callee } from '../calls/call-series.ts';
import { bareCallee, moduleCallee, openModule } from '../calls/module-callee.ts';
import { picturePayload, RECORD_PAYLOAD, type Payload } from '../calls/payload.ts';

/** The measured implementation. */
export type PageSubject = 'bare worker' | 'trusted' | 'sandboxed';
/** The payload of a call. */
export type PagePayload = 'record' | 'picture';
/** Result of a series of calls in the page. */
export type PageResult = ReturnType<CallSeries<unknown, unknown>['result']>;

const PAYLOADS: { readonly [P in PagePayload]: Payload } = {
  record: RECORD_PAYLOAD,
  picture: picturePayload(),
};

const sandboxes = createBrowserSandboxes();
const callees = new Map<string, Callee<unknown, unknown>>();

/** A worker that answers one message at a time, see bare-web-worker.js. */
function startBareWorker() {
  const worker = new Worker('/bare-web-worker.js');
  return {
    call: (message: unknown, transfer: readonly ArrayBuffer[]) =>
      new Promise<unknown>((resolve, reject) => {
        worker.onmessage = ({ data }) => resolve(data);
        worker.onerror = (event) => reject(new Error(event.message));
        worker.postMessage(message, [...transfer]);
      }),
  };
}

async function calleeOf(subject: PageSubject, name: PagePayload) {
  const id = `${subject} ${name}`;
  let callee = callees.get(id);
  if (callee === undefined) {
    const payload = PAYLOADS[name];
    callee = (
      subject === 'bare worker'
        ? bareCallee(startBareWorker(), payload)
        : moduleCallee(await openModule(sandboxes, payload, id, subject === 'trusted'), payload)
    ) as Callee<unknown, unknown>;
    callees.set(id, callee);
  }
  return callee;
}

async function measure(
  subject: PageSubject,
  payload: PagePayload,
  warmUpMs: number,
  measureMs: number,
): Promise<PageResult> {
  const series = new CallSeries(await calleeOf(subject, payload));
  await series.run(warmUpMs);
  await series.run(measureMs);
  return series.result();
}

/** Interface for the benchmark at `window.moduleCalls`. */
export interface ModuleCalls {
  measure: typeof measure;
}

Object.assign(globalThis, { moduleCalls: { measure } satisfies ModuleCalls });
