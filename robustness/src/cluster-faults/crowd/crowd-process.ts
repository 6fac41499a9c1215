import { Crowd, valuesAt, type CrowdPlan } from './crowd.ts';

/*
 * A process on the machine of a master: its clients, and the requests of the program that leads. Each message is a
 * request with a number, and is answered with a reply that has the same one.
 */

const ASK_TIMEOUT_MS = 20_000;

/** What a crowd process does. Values are JSON. */
const COMMANDS = {
  async join(plan: CrowdPlan): Promise<void> {
    crowd = new Crowd(plan);
    await crowd.join();
  },
  state: (others: number) => crowd?.state(others),
  away: () => crowd?.away() ?? 0,
  begin: () => crowd?.begin(),
  stop: () => crowd?.stop() ?? [],
  behind: (lasts: Record<string, number>) => crowd?.behind(lasts) ?? 0,
  rows: () => crowd?.rows() ?? [],
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

export type CrowdCommands = typeof COMMANDS;

let crowd: Crowd | undefined;

process.on('message', ({ number, command, args }: CrowdRequest) => {
  const run = COMMANDS[command] as (...args: unknown[]) => unknown;
  void Promise.resolve()
    .then(() => run(...args))
    .then(
      (value) => process.send!({ number, value } satisfies CrowdReply),
      (error: unknown) => process.send!({ number, error: String(error) } satisfies CrowdReply),
    );
});
// Who leads is gone.
process.once('disconnect', () => process.exit(0));

export interface CrowdRequest {
  readonly number: number;
  readonly command: keyof CrowdCommands;
  readonly args: readonly unknown[];
}

export interface CrowdReply {
  readonly number: number;
  readonly value?: unknown;
  readonly error?: string;
}
