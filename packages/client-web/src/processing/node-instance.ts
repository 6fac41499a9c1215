import type { ModuleStatistics, ProcessingModuleStatus } from '@ubii/proto';
import type { ModuleFault } from '@ubii/pm-sandbox';

/** One module on this node, for people to look at. */
export interface NodeInstance {
  /** Id of the instance. */
  readonly id: string;
  readonly moduleName: string;
  readonly sessionId: string;
  readonly sessionName: string;
  readonly status: ProcessingModuleStatus;
  /** Why it does not run, if it does not. */
  readonly fault: ModuleFault | undefined;
  /** The last report on it; `undefined` before the first. */
  readonly statistics: ModuleStatistics | undefined;
}
