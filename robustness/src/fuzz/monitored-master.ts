import { MasterProcess } from '@ubii/harness';

import { Witness } from '../fixtures/witness.ts';
import type { Entrance, FuzzTarget } from './entrance.ts';

/** A master with pages and ten thousand topics takes some 200 MiB; what grows with every input passes this soon. */
const MAX_RESIDENT_BYTES = 700 * 1024 * 1024;

/** A master under test with a witness: a client pair that must not notice what is delivered. */
export class MonitoredMaster {
  readonly master: MasterProcess;
  readonly witness: Witness;
  #target: FuzzTarget;

  private constructor(master: MasterProcess, witness: Witness, target: FuzzTarget) {
    this.master = master;
    this.witness = witness;
    this.#target = target;
  }

  static async open(program: string): Promise<MonitoredMaster> {
    const master = await MasterProcess.start({ program });
    try {
      const witness = await Witness.open(master.endpoints.url);
      return new MonitoredMaster(master, witness, await targetOf(master));
    } catch (error) {
      await master.dispose();
      throw error;
    }
  }

  /** Delivers an input; again with a new client when the master removed the fuzzer's own. */
  async deliver(entrance: Entrance, input: Uint8Array): Promise<void> {
    try {
      await entrance.deliver(input, this.#target);
    } catch {
      if (!this.master.isRunning) throw new Error(`The master has ended.\n${tail(this.master)}`);
      this.#target = await targetOf(this.master);
      await entrance.deliver(input, this.#target);
    }
  }

  /** Checks process, witness, health, log and memory. @throws Error that names the problem */
  async check(): Promise<void> {
    const { master, witness } = this;
    if (!master.isRunning) throw new Error(`The master has ended.\n${tail(master)}`);
    await witness.check();
    const { status } = await fetch(new URL('/health', master.endpoints.url));
    if (status !== 200) throw new Error(`/health answers with ${status}.`);
    if (master.failures.length > 0) {
      throw new Error(`The master logged:\n${master.failures.slice(0, 12).join('\n')}`);
    }
    const { residentBytes = 0 } = master.figures();
    if (residentBytes > MAX_RESIDENT_BYTES) {
      throw new Error(`The master has ${Math.round(residentBytes / 1024 / 1024)} MiB resident.`);
    }
  }

  async close(): Promise<void> {
    await this.witness.close();
    await this.master.dispose();
  }
}

async function targetOf(master: MasterProcess): Promise<FuzzTarget> {
  const { client } = await master.call({
    topic: '/services/client/registration',
    client: { name: 'fuzzer', extension: {} },
  });
  return {
    program: master.program,
    master,
    clientId: client!.id,
    resumeToken: client!.extension!.resumeToken,
  };
}

function tail(master: MasterProcess): string {
  return master.log.slice(-12).join('\n');
}
