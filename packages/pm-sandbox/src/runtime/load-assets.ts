import { AssetError } from '../assets/asset-error.ts';
import type { AssetProgress, AssetStore, LoadedAssets } from '../assets/asset-store.ts';
import type { Clock } from '../ports/clock.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { InstanceSpec } from './module-runtime.ts';
import type { InstanceReports } from './reports/instance-reports.ts';

/** How often progress is told, milliseconds. */
const TELL_MS = 1000;
const MEGABYTE = 1e6;

/** What a runtime has for it. */
export interface AssetContext {
  readonly assets: AssetStore | undefined;
  readonly clock: Pick<Clock, 'monotonicMs'>;
}

/** Loads the asset sets a module names, and tells how far that is. [PM-90] [PM-94] */
export async function loadAssets(
  { module, isTrusted }: Pick<InstanceSpec, 'module' | 'isTrusted'>,
  { assets, clock }: AssetContext,
  reports: Pick<InstanceReports, 'log'>,
  signal: AbortSignal,
): Promise<{ readonly sets: readonly LoadedAssets[] } | { readonly fault: ModuleFault }> {
  const names = module.extension?.assets ?? [];
  const failed = (message: string) =>
    ({ fault: { kind: 'library', phase: 'onCreated', message } }) as const;
  if (!isTrusted) {
    return failed(
      `The module needs the asset sets ${names.join(', ')}, which only trusted modules get. Put it into the folder of modules (--modules) of its node.`,
    );
  }
  if (assets === undefined) return failed('This node does not load asset sets.');
  let toldMs = -Infinity;
  const tell = ({ name, loadedBytes, totalBytes }: AssetProgress): void => {
    const nowMs = clock.monotonicMs();
    if (nowMs - toldMs < TELL_MS && loadedBytes < totalBytes) return;
    toldMs = nowMs;
    const percent = totalBytes === 0 ? 100 : Math.floor((loadedBytes / totalBytes) * 100);
    const megabytes = (totalBytes / MEGABYTE).toFixed(1);
    reports.log('info', `Loading the asset set ${name}: ${percent} % of ${megabytes} MB.`);
  };
  try {
    return { sets: await assets.load(names, signal, tell) };
  } catch (cause) {
    if (signal.aborted) return failed('The module was stopped while its asset sets were loaded.');
    if (cause instanceof AssetError) return failed(cause.message);
    throw cause;
  }
}
