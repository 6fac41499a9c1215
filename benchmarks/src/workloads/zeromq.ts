import { fileURLToPath } from 'node:url';
import { MasterProcess } from '@ubii/harness';
import { encodeRecord } from '@ubii/proto';
import { recordFrameHeader } from '@ubii/proto/wire';
import { Dealer } from 'zeromq';
import { startBrokerProcess } from '../brokers/broker-process.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Subject, Workload } from '../measuring/workload.ts';
import { percentile } from '../statistics.ts';

const BARE = 'zeromq';
const OURS = 'ubii';
const ECHO = fileURLToPath(new URL('../brokers/zeromq-echo.mjs', import.meta.url));
const TOPIC = '/benchmark/zeromq';
/** Characters that make a record about 100 bytes long. */
const VALUE_CHARACTERS = 60;
/** Different records, sent in turn. */
const RECORDS = 64;
/** No answer for so long: the record is lost. */
const STALL_MS = 2_000;

/** The client of both is libzmq, so that only what is at the other end differs. */
export const zeromq: Workload = {
  name: 'zeromq',
  group: 'zeromq',
  title: 'Round trip over ZeroMQ, 100 B record, closed loop',
  figures: [
    { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: { [OURS]: 1.15 } },
    { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: { [OURS]: 1.2 } },
    {
      key: 'cpuUs',
      label: 'broker CPU a message',
      unit: 'µs',
      isHigherBetter: false,
      goals: { [OURS]: 1.25 },
    },
  ],
  reference: BARE,
  placement: 'core-each',
  roundShare: 1,
  open: async ({ parts, master, profileDir }) => {
    const echo = await parts.get('zeromq-echo', () =>
      startBrokerProcess({ name: BARE, args: [ECHO], profileDir }),
    );
    const running = await parts.get('master-zeromq', () =>
      MasterProcess.start({ program: master, profileDir, flags: ['--zeromq-ports', '0,0'] }),
    );
    const { server } = await running.call({ topic: '/services/server_configuration' });
    return [
      subjectOf(BARE, echo.pid, () => dial(String(echo.endpoints['topicData']))),
      subjectOf(OURS, running.pid, () =>
        join(running, `tcp://127.0.0.1:${server?.portTopicDataZmq}`),
      ),
    ];
  },
};

/** A client that gets back what it sends. */
interface Echoed {
  readonly dealer: Dealer;
  leave(): Promise<void>;
}

function subjectOf(name: string, pid: number, open: () => Promise<Echoed>): Subject {
  return { name, pids: [pid], measure: (options) => measure(pid, open, options) };
}

function dial(address: string, routingId?: string): Promise<Echoed> {
  const dealer = new Dealer({
    linger: 0,
    receiveTimeout: STALL_MS,
    ...(routingId !== undefined && { routingId }),
  });
  dealer.connect(address);
  return Promise.resolve({ dealer, leave: () => Promise.resolve(dealer.close()) });
}

/** Registers as an existing client does, and subscribes to what it publishes. */
async function join(master: MasterProcess, address: string): Promise<Echoed> {
  const { client } = await master.call({
    topic: '/services/client/registration',
    client: { name: 'benchmark' },
  });
  if (client === undefined) throw new Error('The master registered no client.');
  const { id } = client;
  const { dealer } = await dial(address, id);
  await master.call({
    topic: '/services/topic_subscription',
    topicSubscription: { clientId: id, subscribeTopics: [TOPIC] },
  });
  return {
    dealer,
    async leave() {
      await master.call({ topic: '/services/client/deregistration', client: { id } });
      dealer.close();
    },
  };
}

const frames = Array.from({ length: RECORDS }, (_, i) => {
  const value = String(i).padEnd(VALUE_CHARACTERS, '.');
  const record = encodeRecord({ topic: TOPIC, format: 'string', value });
  return Buffer.concat([recordFrameHeader(record.length), record]);
});

async function measure(
  pid: number,
  open: () => Promise<Echoed>,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const { dealer, leave } = await open();
  const faults = new Set<string>();
  let next = 0;
  const exchange = async (): Promise<void> => {
    const frame = frames[next++ % RECORDS]!;
    await dealer.send(frame);
    for (;;) {
      const [, content] = await dealer.receive();
      if (content?.equals(frame)) return;
      if (content?.toString() === 'PING') await dealer.send('PONG');
      else faults.add('a record came back altered');
    }
  };
  const samples: number[] = [];
  try {
    const warmMs = performance.now() + warmUpMs;
    while (performance.now() < warmMs) await exchange();
    const stopLap = startLap([pid]);
    const endMs = performance.now() + measureMs;
    for (let startMs = performance.now(); startMs < endMs; startMs = performance.now()) {
      await exchange();
      samples.push((performance.now() - startMs) * 1000);
    }
    const lap = stopLap();
    const sorted = samples.sort((a, b) => a - b);
    return {
      figures: {
        p50Us: percentile(sorted, 0.5),
        p99Us: percentile(sorted, 0.99),
        cpuUs: lap.cpuUs / samples.length,
      },
      otherCpuShare: lap.otherCpuShare,
      deliveries: samples.length,
      faults: [...faults],
    };
  } finally {
    await leave();
  }
}
