import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { encodeRecord } from '@ubii/proto';
import { startBrokerProcess } from '../brokers/broker-process.ts';
import { TICKER_HERTZ, TICKER_MODULE } from './ticker-module.ts';

/** Values that are replaced; the first one says where they are. */
const PLACEHOLDER = { x: 1.2345678901234567, y: 2, z: 3 };
const TIMESTAMP_MS = 1_750_000_000_000;

/** A process with one bare worker that does what the ticker modules do, see ticker-host.mjs. */
export interface TickerHost {
  readonly pid: number;
  /** Whoever connects gets the records; the tickers run as long as it is connected. */
  readonly url: string;
  stop(): Promise<void>;
}

/** @param topics one for each ticker */
export async function startTickerHost(
  topics: readonly string[],
  profileDir: string | undefined,
): Promise<TickerHost> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-ticker-'));
  const file = join(folder, 'setting.json');
  await writeFile(
    file,
    JSON.stringify({
      source: TICKER_MODULE.onProcessingStringified,
      hertz: TICKER_HERTZ,
      records: topics.map(template),
    }),
  );
  const process = await startBrokerProcess({
    name: 'ticker-host',
    args: [fileURLToPath(new URL('./ticker-host.mjs', import.meta.url)), file],
    profileDir,
  });
  return {
    pid: process.pid,
    url: String(process.endpoints['url']),
    stop: async () => {
      await process.stop();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

function template(topic: string): { base64: string; offset: number } {
  const bytes = Buffer.from(
    encodeRecord({ topic, format: 'vector3', value: PLACEHOLDER, timestampMs: TIMESTAMP_MS }),
  );
  const double = Buffer.alloc(8);
  double.writeDoubleLE(PLACEHOLDER.x);
  return { base64: bytes.toString('base64'), offset: bytes.indexOf(double) };
}
