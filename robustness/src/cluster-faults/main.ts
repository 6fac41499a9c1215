import { execFileSync, spawn } from 'node:child_process';
import { randomInt } from 'node:crypto';
import { freemem } from 'node:os';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { BUILT_MASTER, describeEnd } from '@ubii/harness';

import { FAULTS } from './faults.ts';
import { removeLeftovers } from './leftovers.ts';
import { LoopbackNetwork, type ClusterNetwork } from './network/cluster-network.ts';
import { NetworkNamespaces, NamespaceNetwork } from './network/namespace-network.ts';
import { MASTER_COUNT, runFaults } from './run.ts';

const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** Prints why this process ends before its run is done, unless SIGKILL ends it. Call `done()` at the end of the run. */
function reportEarlyEnd(): { done(): void } {
  let isDone = false;
  for (const signal of SIGNALS) {
    process.once(signal, () => {
      console.error(`The run ends before its time: ${signal}.`);
      isDone = true;
      process.exit(1);
    });
  }
  // The controlling program has ended, as by kill -9.
  process.once('disconnect', () => {
    console.error('The run ends before its time: the program that started it is gone.');
    isDone = true;
    process.exit(1);
  });
  process.once('exit', (code) => {
    if (isDone) return;
    console.error(
      `The run ended before its time, with ${code}: it failed, or nothing was left to wait for.`,
    );
    if (code === 0) process.exitCode = 1;
  });
  return { done: () => (isDone = true) };
}

const HELP = `Injects faults into a cluster of ${MASTER_COUNT} masters under a workload, and finds lost changes and records.

  npm run cluster-faults                       every fault, with ${MASTER_COUNT} × 2000 clients: some ten minutes
  npm run cluster-faults -- --clients 50 --only calm,kill-master

  --clients <n>     clients on the machine of each master (default 2000)
  --topics <n>      topics whose publishers are on each machine (default 10)
  --rate <Hz>       records of a topic a second (default 1)
  --subscribe <n>   topics that each client subscribes to (default 2)
  --only <name>,…   ${FAULTS.map(({ name }) => name).join(', ')}
  --seed <n>        the same seed gives the same requests (default: random; it is printed)
  --loopback        without network namespaces
  --master <file>   another build of the master
  --help            this text

Each master and its clients are in a network namespace, which takes root on Linux; elsewhere all are on loopback.
Needs nats-server. Ends with 1 when something is against docs/spec/clusters.md.`;

/** Memory of a client and its share of the masters, with a reserve. */
const BYTES_PER_CLIENT = 600_000;

const { values } = parseArgs({
  options: {
    clients: { type: 'string', default: '2000' },
    topics: { type: 'string', default: '10' },
    rate: { type: 'string', default: '1' },
    subscribe: { type: 'string', default: '2' },
    only: { type: 'string' },
    seed: { type: 'string' },
    loopback: { type: 'boolean', default: false },
    master: { type: 'string' },
    network: { type: 'string' },
    help: { type: 'boolean', short: 'h' },
  },
});

if (values.help) console.log(HELP);
else if (values.network !== undefined) {
  await run(new NamespaceNetwork(new NetworkNamespaces(values.network, MASTER_COUNT)));
} else await chooseNetwork();

async function chooseNetwork(): Promise<void> {
  for (const what of removeLeftovers()) console.log(`removed what an earlier run left: ${what}`);
  const reason = values.loopback ? 'as wanted' : NetworkNamespaces.reasonAgainst();
  if (reason === undefined) return runInNetwork();
  console.warn(`No network namespaces: ${reason}.`);
  return run(new LoopbackNetwork(MASTER_COUNT));
}

/** Runs itself once more, in the hub of a network that is made for it and removed after it. */
async function runInNetwork(): Promise<void> {
  const network = new NetworkNamespaces(String(process.pid), MASTER_COUNT);
  process.once('exit', () => network.close());
  network.open();
  const node = [process.execPath, '--import', import.meta.resolve('tsx')];
  const own = [fileURLToPath(import.meta.url), ...process.argv.slice(2)];
  const command = ['netns', 'exec', network.hub, ...node, ...own, '--network', String(process.pid)];
  // The channel closes when this process ends.
  const child = spawn('ip', command, { stdio: ['inherit', 'inherit', 'inherit', 'ipc'] });
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) {
    process.on(signal, () => child.kill(signal));
  }
  process.exitCode = await new Promise<number>((done) =>
    child.once('exit', (code, signal) => {
      if (code === null) console.error(`The run ${describeEnd(code, signal)}.`);
      done(code ?? 1);
    }),
  );
}

async function run(network: ClusterNetwork): Promise<void> {
  const wanted = values.only?.split(',') ?? FAULTS.map(({ name }) => name);
  const faults = FAULTS.filter(({ name }) => wanted.includes(name));
  if (faults.length !== new Set(wanted).size) {
    console.error(`--only needs names of ${FAULTS.map(({ name }) => name).join(', ')}.`);
    process.exitCode = 2;
    return;
  }
  const ending = reportEarlyEnd();
  const seed = values.seed === undefined ? randomInt(2 ** 32) : Number(values.seed);
  console.log(`seed ${seed}, ${network.about}`);
  const reports = await runFaults({
    network,
    faults,
    seed,
    canOpenMore: canOpenMore(),
    program: values.master === undefined ? BUILT_MASTER : fromCaller(values.master),
    clients: affordable(Number(values.clients)),
    topics: Number(values.topics),
    topicsPerClient: Number(values.subscribe),
    periodMs: 1000 / Number(values.rate),
    say: (text) => console.log(text),
  });
  const broken = reports.reduce((sum, { violations }) => sum + violations.length, 0);
  console.log(broken === 0 ? 'nothing is broken' : `${broken} broken`);
  ending.done();
  process.exit(broken === 0 ? 0 : 1);
}

/** As many clients as fit into the memory that is free. */
function affordable(clients: number): number {
  const most = Math.floor(freemem() / MASTER_COUNT / BYTES_PER_CLIENT);
  if (clients <= most) return clients;
  console.warn(`The free memory is enough for ${most} clients a master, and not for ${clients}.`);
  return most;
}

/** Whether masters may have more descriptors than this process. */
function canOpenMore(): boolean {
  try {
    execFileSync('bash', ['-c', 'ulimit -n 65536'], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}

function fromCaller(path: string): string {
  return resolve(process.env['INIT_CWD'] ?? process.cwd(), path);
}
