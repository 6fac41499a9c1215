import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import type { Init, ProcessingModule } from '@ubii/proto';
import { joinMaster } from '../brokers/brokers.ts';
import { LoadConnection } from '../load/load-connection.ts';
import { RecordReceiver } from '../load/record-receiver.ts';
import { startSession, writeModuleFolder } from '../modules/running-session.ts';
import {
  startTickerHost,
  TICKER_HERTZ,
  TICKER_MODULE,
  TickerWatch,
  type TickerHost,
} from '../modules/ticker.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Subject, Workload } from '../measuring/workload.ts';

const MODULES = 100;
const REFERENCE = 'bare worker';
/** As long as the measurements of other workloads are, there would be few runs of each module. */
const LENGTH_FACTOR = 2;
const BEGIN_TIMEOUT_MS = 5_000;
const POLL_MS = 20;

/** Many modules at a frequency on the master, beside a process with timers and one worker. */
export const modules100: Workload = {
  name: 'modules-100',
  group: 'modules-100',
  title: `${MODULES} modules at ${TICKER_HERTZ} Hz on the master, one subscriber to all outputs`,
  figures: [
    {
      key: 'cpu',
      label: 'CPU, all threads',
      unit: 'cores',
      isHigherBetter: false,
      goals: { trusted: 1.5, sandboxed: 1.5 },
    },
    {
      key: 'startP99Ms',
      label: 'start off its place, p99',
      unit: 'ms',
      isHigherBetter: false,
      goals: {},
      bounds: { trusted: 2, sandboxed: 2 },
    },
    {
      key: 'arrivalP99Ms',
      label: 'output behind earliest, p99',
      unit: 'ms',
      isHigherBetter: false,
      goals: {},
    },
    {
      key: 'leftOut',
      label: 'runs left out',
      unit: '%',
      isHigherBetter: false,
      goals: {},
      bounds: { trusted: 0, sandboxed: 0 },
    },
  ],
  reference: REFERENCE,
  // Many threads have work at once: they get what the machine has.
  placement: 'anywhere',
  roundShare: 1 / 3,
  open: async ({ parts, master: file, profileDir }) => {
    const folder = await parts.get('modules', () => writeModuleFolder([TICKER_MODULE]));
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir, flags: ['--modules', folder.path] }),
    );
    const bareTopics = topicsOf('bare');
    const host = await parts.get('ticker host', () => startTickerHost(bareTopics, profileDir));
    return [
      {
        name: REFERENCE,
        pids: [host.pid],
        measure: (options) => measureHost(host, bareTopics, options),
      },
      onMaster(master, 'trusted', { name: TICKER_MODULE.name }),
      // Another name: that of the folder's module would be known, and trusted.
      onMaster(master, 'sandboxed', { ...TICKER_MODULE, name: 'benchmark-ticker-of-session' }),
    ];
  },
};

function topicsOf(name: string): string[] {
  return Array.from({ length: MODULES }, (_, index) => `/benchmark/tickers/${name}/${index}`);
}

function onMaster(
  master: MasterProcess,
  name: string,
  module: Init<ProcessingModule> & { name: string },
): Subject {
  const topics = topicsOf(name);
  const measure = async (options: MeasureOptions): Promise<Measurement> => {
    const { receiver, watch } = watchTopics(topics);
    const client = await joinMaster(master, { publishes: false, topics }, receiver, true);
    try {
      const session = await startSession(master, {
        name: `tickers ${name}`,
        processingModules: topics.map(() => module),
        ioMappings: topics.map((topic) => ({
          processingModuleName: module.name,
          outputMappings: [{ outputName: 'out', topic }],
        })),
      });
      const measurement = await measureTickers(watch, receiver, [master.pid], options);
      await session.stop();
      return measurement;
    } finally {
      await client.leave();
    }
  };
  return { name, pids: [master.pid], measure };
}

async function measureHost(
  host: TickerHost,
  topics: readonly string[],
  options: MeasureOptions,
): Promise<Measurement> {
  const { receiver, watch } = watchTopics(topics);
  const connection = await LoadConnection.open(host.url, receiver);
  const measurement = await measureTickers(watch, receiver, [host.pid], options);
  await connection.close();
  return measurement;
}

function watchTopics(topics: readonly string[]) {
  const watch = new TickerWatch(topics);
  const receiver = new RecordReceiver();
  let arrivedMs = 0;
  receiver.onFrame = () => (arrivedMs = performance.now());
  receiver.onRecord = (record) => watch.handleRecord(record, arrivedMs);
  return { receiver, watch };
}

async function measureTickers(
  watch: TickerWatch,
  receiver: RecordReceiver,
  pids: readonly number[],
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const untilMs = performance.now() + BEGIN_TIMEOUT_MS;
  while (!watch.haveAllBegun && performance.now() < untilMs) await sleep(POLL_MS);
  if (!watch.haveAllBegun) watch.faults.push('not all modules put something out');
  await sleep(warmUpMs);
  watch.start();
  const stopLap = startLap(pids);
  await sleep(LENGTH_FACTOR * measureMs);
  const lap = stopLap();
  const { runs, leftOut, startP99Ms, arrivalP99Ms } = watch.stop();
  return {
    figures: {
      cpu: lap.cpuUs / lap.wallUs,
      startP99Ms,
      arrivalP99Ms,
      leftOut: (100 * leftOut) / (runs + leftOut),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: runs,
    faults: [...watch.faults, ...receiver.faults],
  };
}
