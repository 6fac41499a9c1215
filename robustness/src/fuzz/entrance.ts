import type { MasterProcess } from '@ubii/harness';

import type { Random } from '../random.ts';

/** Target of a fuzz run. */
export interface FuzzTarget {
  /** Main file of the master, for those who start one of their own. */
  readonly program: string;
  /** The one under test; with entrances of kind `running` alone. */
  readonly master: MasterProcess;
  /** Id of a client that exists for the fuzzer, with its token. */
  readonly clientId: string;
  readonly resumeToken: string;
}

/** An entrance of bytes into the master. */
export interface Entrance {
  readonly name: string;
  /** Description of the inputs. */
  readonly about: string;
  /** Receiver of an input: a running master, a master that it starts with, or a parser in this process. */
  readonly kind: 'running' | 'start' | 'parser';
  /** Inputs in the gate. Default: by the kind. */
  readonly gateCases?: number;
  /** Good inputs, to begin with. */
  seeds(): readonly Uint8Array[];
  mutate(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array;
  /**
   * Delivers one input; resolves when the master has answered it or hung up.
   *
   * @throws Error when what came back is no answer
   */
  deliver(input: Uint8Array, target: FuzzTarget): Promise<void>;
}
