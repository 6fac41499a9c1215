import { fileURLToPath } from 'node:url';

import { findBuilt, readVersion, runProgram, shutDownOnRequest } from '@ubii/program';

import { createConfig, MASTER_PROGRAM } from './adapters/config/config.ts';
import { LinesAfter } from './adapters/log/stream-log.ts';
import { StreamLog } from './adapters/log/stream-log.ts';
import { FaultGuard } from './adapters/process/fault-guard.ts';
import { allowHeapGrowth } from './adapters/process/heap-growth.ts';
import { bestPhoneUrl, formatBanner, joinUrl } from './adapters/terminal/banner.ts';
import { formatEndpoints } from './adapters/terminal/banner.ts';
import { formatFarewell } from './adapters/terminal/session-lines.ts';
import { formatRestored } from './adapters/terminal/session-lines.ts';
import { formatQrCode } from './adapters/terminal/banner.ts';
import type { Config } from './adapters/config/config.ts';
import { DEFAULT_LIMITS, LogTail } from './index.ts';
import type { RunningMaster } from './running-master.ts';
import { startMaster } from './start-master.ts';

/** Everything is closed by then, or the process ends without it. */
const SHUTDOWN_DEADLINE_MS = 1_500;

const version = readVersion(import.meta.url);
// From src as well as from dist.
const frontendFolder = fileURLToPath(new URL('../../frontend/dist', import.meta.url));
const sdkFolder = fileURLToPath(new URL('../../../packages/client-web/dist/sdk', import.meta.url));
// Those that come with the program; the operator's are in the data directory.
const assetsFolders = ['packages/vision', 'demos/ubi-party'].map((folder) =>
  fileURLToPath(new URL(`../../../${folder}/dist/assets`, import.meta.url)),
);
const workerFile = findBuilt('pm-worker.js', import.meta.url);
const decodeWorkerFile = findBuilt('decode-worker.js', import.meta.url);
const recorderWorkerFile = findBuilt('recorder-worker.js', import.meta.url);
const checkProcessFile = findBuilt('check-process.js', import.meta.url);
const replayWorkerFile = findBuilt('replay-worker.js', import.meta.url);

allowHeapGrowth();
await runProgram(MASTER_PROGRAM, (options) => run(createConfig(options)), { version });

async function run(config: Config): Promise<void> {
  // The banner comes first on a terminal, then what was logged meanwhile.
  const lines = new LinesAfter((line) => process.stderr.write(`${line}\n`));
  const log = createLog(config, lines);
  try {
    const master = await startMaster({
      config,
      log,
      version,
      frontendFolder,
      sdkFolder,
      assetsFolders,
      workerFile,
      decodeWorkerFile,
      recorderWorkerFile,
      checkProcessFile,
      replayWorkerFile,
    });
    endInGoodOrder(master, log, config);
    await present(master, config);
  } finally {
    lines.open();
  }
}

function createLog({ logLevel, logFormat, limits }: Config, lines: LinesAfter): LogTail {
  const format = logFormat === 'auto' ? (process.stderr.isTTY ? 'text' : 'json') : logFormat;
  const written = new StreamLog({
    level: logLevel,
    format,
    write: (line) => lines.write(line),
    nowMs: Date.now,
  });
  return new LogTail(written, Date.now, logLevel === 'debug', { ...DEFAULT_LIMITS, ...limits });
}

function endInGoodOrder(master: RunningMaster, log: LogTail, config: Config): void {
  const end = shutDownOnRequest({
    deadlineMs: SHUTDOWN_DEADLINE_MS,
    async close() {
      const farewell = formatFarewell(master.sessionsAtStop());
      await master.close();
      // For programs standard output is one line of JSON.
      if (config.printEndpoints === 'json') return;
      await new Promise((done) => process.stdout.write(`${farewell}\n`, done));
    },
    onError: (error) => log.error('closing failed', { reason: String(error) }),
  });

  const faults = new FaultGuard(log, () => end(1));
  process.on('uncaughtException', (error) => faults.handle('uncaught error', error, Date.now()));
  process.on('unhandledRejection', (error) =>
    faults.handle('unhandled rejection', error, Date.now()),
  );
}

async function present(master: RunningMaster, config: Config): Promise<void> {
  const reachability = master.reachability();
  const forPrograms = config.printEndpoints === 'json';
  const screen = forPrograms ? process.stderr : process.stdout;
  screen.write(
    formatBanner({
      name: config.name,
      version,
      dataDir: config.dataDir,
      ports: master.ports,
      reachability,
      terminal: master.terminal,
      loopback: master.loopback,
      devUrl: process.env['UBII_DEV_FRONTEND_URL'],
    }),
  );
  const phoneUrl = bestPhoneUrl(reachability);
  const join = master.terminal?.join;
  if (phoneUrl !== undefined && join !== undefined && screen.isTTY) {
    screen.write(`\n${await formatQrCode(joinUrl(phoneUrl, join.token))}\n`);
  }
  if (forPrograms) {
    process.stdout.write(
      `${formatEndpoints(reachability.localUrl, process.pid, master.terminal)}\n`,
    );
  }
  // Modules may take seconds to start, or wait for nodes: nobody waits for that.
  void master.sessionsRestored().then((report) => screen.write(formatRestored(report)));
}
