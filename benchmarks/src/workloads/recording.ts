import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { joinMaster } from '../brokers/brokers.ts';
import { mainThreadCpuUs } from '../cpu-time.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { FlowWindow } from '../load/flow-window.ts';
import { createRecordRing, MAX_WINDOW, type RecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';

const RECORD_BYTES = 100;
const RECORDS_PER_SECOND = 50_000;
const SUBSCRIBERS = 4;
/** Between two bursts of the publisher. */
const STEP_MS = 2;
/** Records that may be under way: a master that is late is not flooded, and drops nothing. */
const WINDOW = MAX_WINDOW;
/** The last record did not come for so long: what is missing is lost. */
const STALL_MS = 2_000;

const OFF = 'off';
const FLIGHT = 'flight recorder';
const RECORDING = 'recording';

/** One client publishes to a few, while the master records nothing, the last minutes, or a file. */
export const recording: Workload = {
  name: 'recording',
  group: 'recording',
  title: `Recording ${RECORDS_PER_SECOND} records/s of ${RECORD_BYTES} B with ${SUBSCRIBERS} subscribers`,
  figures: [
    {
      key: 'mainCpuUs',
      label: 'CPU a record, main thread',
      unit: 'µs',
      isHigherBetter: false,
      goals: { [FLIGHT]: 1.1, [RECORDING]: 1.1 },
    },
    {
      key: 'cpuUs',
      label: 'CPU a record, all threads',
      unit: 'µs',
      isHigherBetter: false,
      goals: {},
    },
    {
      key: 'recordsPerS',
      label: 'records',
      unit: '1/s',
      isHigherBetter: true,
      goals: {},
    },
  ],
  reference: OFF,
  placement: 'anywhere',
  roundShare: 1,
  open: async ({ parts, master, profileDir }) => {
    const ring = createRecordRing('recording', RECORD_BYTES);
    const running = await parts.get('master', () =>
      MasterProcess.start({ program: master, profileDir }),
    );
    return [OFF, FLIGHT, RECORDING].map((name) => ({
      name,
      pids: [running.pid],
      measure: (options) => measure(running, name, ring, options),
    }));
  },
};

async function measure(
  master: MasterProcess,
  name: string,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  await master.call({
    topic: SERVICES.flightRecorderSet.topic,
    flightRecorderSettings: { isOn: name === FLIGHT, withImages: true },
  });
  const id = name === RECORDING ? await startRecording(master) : '';
  const subscribers = await Promise.all(
    Array.from({ length: SUBSCRIBERS }, async () => {
      const verifier = new DeliveryVerifier(ring);
      const role = { publishes: false, topics: [ring.topic] };
      return { verifier, ...(await joinMaster(master, role, verifier, true)) };
    }),
  );
  const published = new DeliveryVerifier(ring);
  const role = { publishes: true, topics: [] };
  const publisher = await joinMaster(master, role, published, true);
  let onIdle: () => void = () => {};
  const flow = new FlowWindow(SUBSCRIBERS, WINDOW);
  for (const { verifier } of subscribers) {
    let before = 0;
    verifier.onProgress = () => {
      const now = Math.min(verifier.next, sent);
      if (now > before) flow.advance(before, now);
      before = now;
      if (flow.slowest === sent) onIdle();
    };
  }
  let sent = 0;
  const startMs = performance.now();
  const timer = setInterval(() => {
    const due = ((performance.now() - startMs) / 1000) * RECORDS_PER_SECOND;
    const count = Math.min(Math.floor(due) - sent, WINDOW - (sent - flow.slowest));
    if (count <= 0) return;
    publisher.connection.send(ring.published.slice(sent, count));
    sent += count;
  }, STEP_MS);
  await sleep(warmUpMs);
  const sentBefore = sent;
  const mainBefore = mainThreadCpuUs(master.pid);
  const stopLap = startLap([master.pid]);
  await sleep(measureMs);
  const lap = stopLap();
  const mainUs = mainThreadCpuUs(master.pid) - mainBefore;
  const records = sent - sentBefore;
  clearInterval(timer);
  const idle = new Promise<void>((resolve) => (onIdle = resolve));
  if (flow.slowest < sent) await Promise.race([idle, sleep(STALL_MS, undefined, { ref: false })]);
  for (const { verifier } of subscribers) verifier.finish(sent);
  published.finish(0);
  const faults = describeFaults(
    [published, ...subscribers.map((each) => each.verifier)].map((verifier) => verifier.faults),
  );
  if (id !== '') faults.push(...(await faultsOf(master, id, sent)));
  await Promise.all([publisher, ...subscribers].map((client) => client.leave()));
  return {
    figures: {
      mainCpuUs: mainUs / records,
      cpuUs: lap.cpuUs / records,
      recordsPerS: records / (lap.wallUs / 1e6),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: records * SUBSCRIBERS,
    faults,
  };
}

async function startRecording(master: MasterProcess): Promise<string> {
  const request = { topic: SERVICES.recordingStart.topic, recordingStartRequest: {} };
  return (await master.call(request)).recording?.id ?? '';
}

/** Stops and deletes the recording. Returns what is missing in it. */
async function faultsOf(master: MasterProcess, id: string, sent: number): Promise<string[]> {
  const recordingRequest = { id };
  const { recording: done } = await master.call({
    topic: SERVICES.recordingStop.topic,
    recordingRequest,
  });
  await master.call({ topic: SERVICES.recordingDelete.topic, recordingRequest });
  const recorded = done?.recordCount ?? 0;
  return recorded === sent ? [] : [`the recording has ${recorded} of ${sent} records`];
}
