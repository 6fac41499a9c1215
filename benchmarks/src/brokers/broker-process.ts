import { cpuProfileFlags, ServerProcess } from '@ubii/harness';

export interface BrokerProcess {
  readonly pid: number;
  /** The JSON object of the first line it printed. */
  readonly endpoints: Readonly<Record<string, unknown>>;
  stop(): Promise<void>;
}

export interface BrokerCommand {
  readonly name: string;
  /** Script and its arguments, run by the same Node as this one. */
  readonly args: readonly string[];
  /** Directory for a CPU profile of the whole run, written when the broker stops. */
  readonly profileDir: string | undefined;
}

/** Starts a broker and waits for the line of JSON that says where it listens. */
export async function startBrokerProcess(command: BrokerCommand): Promise<BrokerProcess> {
  const { name, args, profileDir } = command;
  const server = await ServerProcess.start({
    name: `The broker ${name}`,
    command: [process.execPath, ...cpuProfileFlags(profileDir, name), ...args],
  });
  return { pid: server.pid, endpoints: server.ready, stop: () => server.end() };
}
