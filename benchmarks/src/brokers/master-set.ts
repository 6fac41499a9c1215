import { MasterProcess, startNats } from '@ubii/harness';

/** Masters that work as one, or one that is alone, with what connects them. */
export interface MasterSet {
  readonly masters: readonly MasterProcess[];
  /** Processes that are there for the masters: NATS, a proxy. */
  readonly helpers: readonly number[];
  stop(): Promise<void>;
}

export interface MasterSetStart {
  /** Main file of the masters. */
  readonly program: string;
  readonly profileDir: string | undefined;
}

/** One master that is in no cluster. */
export async function startOneMaster(start: MasterSetStart): Promise<MasterSet> {
  const master = await MasterProcess.start(start);
  return { masters: [master], helpers: [], stop: () => master.dispose() };
}

/**
 * Masters of one cluster, with a NATS server of their own.
 *
 * @throws Error that says how to get NATS when it is missing
 */
export async function startMasterCluster(start: MasterSetStart, count: number): Promise<MasterSet> {
  const nats = await startNats({ jetstream: true });
  const masters: MasterProcess[] = [];
  const stop = async (): Promise<void> => {
    await Promise.all(masters.map((master) => master.dispose()));
    await nats.stop();
  };
  try {
    // One after the other: the first one creates the stores.
    while (masters.length < count) {
      masters.push(await MasterProcess.start({ ...start, flags: ['--cluster', nats.url] }));
    }
    return { masters, helpers: [nats.pid!], stop };
  } catch (error) {
    await stop();
    throw error;
  }
}
