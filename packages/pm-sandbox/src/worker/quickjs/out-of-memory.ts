import type { ModuleFault, ModulePhase } from '../../ports/module-fault.ts';
import type { SandboxLimits } from '../../ports/sandbox.ts';
import type { MemoryAccount, MemoryShortage } from '../memory-account.ts';
import { moduleFault } from '../module-error.ts';

/** Error that ends an instance which did not get memory. [PM-52] [PM-58] */
export function outOfMemory(
  phase: ModulePhase,
  shortage: 'own' | MemoryShortage,
  limits: SandboxLimits,
  memory: MemoryAccount | undefined,
): ModuleFault {
  if (shortage === 'own' || memory === undefined) {
    const megabytes = Math.round(limits.memoryBytes / 1024 / 1024);
    const message = `${phase} needs more than ${megabytes} MB of memory, the limit of one module.`;
    return moduleFault('memory', phase, message);
  }
  const whose =
    shortage === 'all'
      ? 'all modules of this node share'
      : 'the modules of one session share on this node';
  const message = `${phase} needs more memory than is left of the ${memory.limitMegabytes(shortage)} MB that ${whose}.`;
  return { ...moduleFault('memory', phase, message), shortage };
}
