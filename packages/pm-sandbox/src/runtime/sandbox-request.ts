import { plural } from '@ubii/words';

import { parseModule } from '../definition/parse-module.ts';
import type { RuntimeLimits } from '../limits.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxRequest } from '../ports/sandbox.ts';
import { ASSET_CALL_TIMEOUT_MS } from '../sandbox-limits.ts';
import type { InstanceSpec } from './module-runtime.ts';

/**
 * Returns the request to create an instance in a sandbox; or why the node cannot run it, as far as that is visible
 * without its code. [PM-1] [PM-4]
 *
 * @param offered libraries of the node
 */
export function sandboxRequest(
  spec: InstanceSpec,
  limits: RuntimeLimits,
  offered: readonly string[],
): SandboxRequest | { readonly fault: ModuleFault } {
  const parsed = parseModule(spec.module);
  const { name, source, libraries, assets, optionalAssets, inputs, outputs } = parsed;
  if (source === undefined) {
    return { fault: { kind: 'missing', phase: '', message: 'The module has no onProcessing.' } };
  }
  const lacking = libraries.filter((library) => !offered.includes(library));
  if (lacking.length > 0) {
    const message = `This node does not offer ${plural(lacking.length, 'the library', 'the libraries')} ${lacking.join(', ')}.`;
    return { fault: { kind: 'library', phase: '', message } };
  }
  const { memoryBytes, outputBytes } = limits;
  const callTimeoutMs =
    assets.length + optionalAssets.length > 0
      ? Math.max(limits.callTimeoutMs, ASSET_CALL_TIMEOUT_MS)
      : limits.callTimeoutMs;
  return {
    instanceId: spec.module.id,
    moduleName: name,
    source,
    isTrusted: spec.isTrusted,
    libraries,
    assets: [],
    inputs: inputs.map((input) => input.name),
    outputs: outputs.map(({ name: outputName, format }) => ({ name: outputName, format })),
    owner: spec.module.sessionId,
    limits: { callTimeoutMs, memoryBytes, outputBytes },
  };
}
