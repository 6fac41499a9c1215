import type { PreciseClock } from '@ubii/timing';
import type { LoopbackFacts } from './adapters/access/caller-reader.ts';
import type { Config } from './adapters/config/config.ts';
import type { KnownModel } from './adapters/models/catalogue.ts';
import type { ListeningPorts } from './adapters/network/listeners.ts';
import type { Reachability } from './adapters/network/reachability.ts';
import type { LogTail, Master, TerminalAccess } from './index.ts';

/** Parts of a listening master. */
export interface RunningMasterContext {
  readonly config: Config;
  readonly log: LogTail;
  /** Default: that of the system. */
  readonly clock?: PreciseClock;
  readonly version: string;
  /** The built frontend. */
  readonly frontendFolder: string;
  /** The built client library. */
  readonly sdkFolder: string;
  /** Folders of asset sets that come with the program. */
  readonly assetsFolders: readonly string[];
  /** The built worker of processing modules. */
  readonly workerFile: URL;
  /** A connection without a request is closed after this time, milliseconds [AC-63]. Default: 5000. */
  readonly keepAliveMs?: number;
  /** Models that admins can download. Default: those that modules of the library use. */
  readonly models?: readonly KnownModel[];
  /** The built thread that decodes large requests; undefined: the main thread does it. */
  readonly decodeWorkerFile: URL | undefined;
  /** The built thread that records; undefined: the main thread does it. */
  readonly recorderWorkerFile: URL | undefined;
  /** The built process that checks files for the thread that records; undefined: the main thread does it. */
  readonly checkProcessFile: URL | undefined;
  /** The built thread that reads recordings to be played; undefined: the main thread does it. */
  readonly replayWorkerFile: URL | undefined;
}

/** A master that listens. */
export interface RunningMaster {
  readonly ports: ListeningPorts;
  /** Asked again each time: networks come and go. */
  reachability(): Reachability;
  /** Secrets shown in the terminal; undefined when they could not be stored. [AC-19] [AC-42] */
  readonly terminal: TerminalAccess | undefined;
  /**
   * Role of callers on this computer, and whether the system distinguishes the operator's programs from others. [AC-1]
   * [AC-40]
   */
  readonly loopback: LoopbackFacts;
  readonly sessionsAtStop: Master['sessionsAtStop'];
  readonly sessionsRestored: Master['sessionsRestored'];
  /** Closes everything, within a second. */
  close(): Promise<void>;
}
