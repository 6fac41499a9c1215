import { ClientPool, valuesAt, type PoolPlan } from './client-pool.ts';

/*
 * A process on the machine of a master, with its clients. Each message of the controlling program is a request with a
 * number, and is answered with a reply of the same number.
 */

const ASK_TIMEOUT_MS = 20_000;

/** Commands of the controlling program. Values are JSON. */
const COMMANDS = {
  async join(plan: PoolPlan): Promise<void> {
    pool = new ClientPool(plan);
    await pool.join();
  },
  state: (others: number) => pool?.state(others),
  away: () => pool?.away() ?? 0,
  begin: () => pool?.begin(),
  stop: () => pool?.stop() ?? [],
  behind: (lasts: Record<string, number>) => pool?.behind(lasts) ?? 0,
  rows: () => pool?.rows() ?? [],
  values: (url: string, regex: string, waitMs: number) => valuesAt(url, regex, waitMs),
  /** @param body request, in base64 */
  async ask(url: string, body: string): Promise<string> {
    const response = await fetch(`${url}/services/binary`, {
      method: 'POST',
      headers: { 'content-type': 'application/octet-stream' },
      body: Buffer.from(body, 'base64'),
      signal: AbortSignal.timeout(ASK_TIMEOUT_MS),
    });
    return Buffer.from(await response.arrayBuffer()).toString('base64');
  },
  async metrics(url: string): Promise<string> {
    const response = await fetch(`${url}/metrics`, { signal: AbortSignal.timeout(ASK_TIMEOUT_MS) });
    return response.text();
  },
};

export type PoolCommands = typeof COMMANDS;

let pool: ClientPool | undefined;

process.on('message', ({ number, command, args }: PoolRequest) => {
  const run = COMMANDS[command] as (...args: unknown[]) => unknown;
  void Promise.resolve()
    .then(() => run(...args))
    .then(
      (value) => process.send!({ number, value } satisfies PoolReply),
      (error: unknown) => process.send!({ number, error: String(error) } satisfies PoolReply),
    );
});
// The controlling program has ended.
process.once('disconnect', () => process.exit(0));

export interface PoolRequest {
  readonly number: number;
  readonly command: keyof PoolCommands;
  readonly args: readonly unknown[];
}

export interface PoolReply {
  readonly number: number;
  readonly value?: unknown;
  readonly error?: string;
}
