import { plural } from '@ubii/words';
import type { Clock } from '@ubii/timing';
import { parseModule } from '../definition/parse-module.ts';
import type { RuntimeLimits } from '../limits.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxRequest } from '../ports/sandbox.ts';
import { ASSET_CALL_TIMEOUT_MS } from '../sandbox-limits.ts';
import type { InstanceSpec } from './module-runtime.ts';
import { AssetError } from '../assets/asset-error.ts';
import type { AssetProgress, AssetStore, LoadedAssets } from '../assets/asset-store.ts';
import type { InstanceReports } from './reports/instance-reports.ts';

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

/** Interval of progress reports, milliseconds. */
const TELL_MS = 1000;
const MEGABYTE = 1e6;

/** Access of a runtime to asset sets. */
interface AssetContext {
  readonly assets: AssetStore | undefined;
  readonly clock: Pick<Clock, 'monotonicMs'>;
}

/** Reports about loading. */
type LoadingReports = Pick<InstanceReports, 'log' | 'noteLoading'>;

/**
 * Loads an asset set that a running module asks for. [PM-96]
 * @throws AssetError
 */
export async function loadOptionalAssets(
  name: string,
  { module }: Pick<InstanceSpec, 'module'>,
  context: AssetContext,
  reports: LoadingReports,
  signal: AbortSignal,
): Promise<LoadedAssets> {
  if (!(module.extension?.optionalAssets ?? []).includes(name)) {
    throw new AssetError(
      'missing',
      `The module does not list the asset set ${name} in its optionalAssets.`,
    );
  }
  if (context.assets === undefined) {
    throw new AssetError('missing', 'This node does not load asset sets.');
  }
  const [set] = await context.assets
    .load([name], signal, reportProgress(context, reports))
    .finally(() => reports.noteLoading(undefined));
  if (set!.library === undefined) return set!;
  throw new AssetError(
    'damaged',
    `The asset set ${name} is a library. Name it in assets instead of optionalAssets.`,
  );
}

/** Tells how far loading is, in statistics and as log lines of the module. [PM-94] */
function reportProgress(
  { clock }: AssetContext,
  reports: LoadingReports,
): (progress: AssetProgress) => void {
  let toldMs = -Infinity;
  return (progress) => {
    reports.noteLoading(progress);
    const { name, loadedBytes, totalBytes } = progress;
    const nowMs = clock.monotonicMs();
    if (nowMs - toldMs < TELL_MS && loadedBytes < totalBytes) return;
    toldMs = nowMs;
    const percent = totalBytes === 0 ? 100 : Math.floor((loadedBytes / totalBytes) * 100);
    const megabytes = (totalBytes / MEGABYTE).toFixed(1);
    reports.log('info', `Loading the asset set ${name}: ${percent} % of ${megabytes} MB.`);
  };
}

/** Loads the asset sets a module names, and tells how far that is. [PM-90] [PM-94] */
export async function loadAssets(
  { module, isTrusted }: Pick<InstanceSpec, 'module' | 'isTrusted'>,
  context: AssetContext,
  reports: LoadingReports,
  signal: AbortSignal,
): Promise<{ readonly sets: readonly LoadedAssets[] } | { readonly fault: ModuleFault }> {
  const { assets: names = [], optionalAssets = [] } = module.extension ?? {};
  const failed = (message: string) =>
    ({ fault: { kind: 'library', phase: 'onCreated', message } }) as const;
  if (!isTrusted) {
    return failed(
      `The module needs the asset sets ${[...names, ...optionalAssets].join(', ')}, which only trusted modules get. Put it into the folder of modules (--modules) of its node.`,
    );
  }
  if (names.length === 0) return { sets: [] };
  if (context.assets === undefined) return failed('This node does not load asset sets.');
  try {
    return { sets: await context.assets.load(names, signal, reportProgress(context, reports)) };
  } catch (cause) {
    if (signal.aborted) return failed('The module was stopped while its asset sets were loaded.');
    if (cause instanceof AssetError) return failed(cause.message);
    throw cause;
  } finally {
    reports.noteLoading(undefined);
  }
}
