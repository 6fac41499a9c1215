import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import {
  ModuleVersionOrigin,
  ServiceError,
  type ModuleVersion,
  type ProcessingModule,
} from '@ubii/proto';
import type { ModuleDraft } from '../draft/module-draft.ts';

/** Earlier versions of a module, or the reason why there are none. */
export type VersionList =
  | { readonly kind: 'list'; readonly versions: readonly ModuleVersion[] }
  | { readonly kind: 'none'; readonly sentence: string };

/** Earlier version to compare. */
export interface ChosenVersion {
  readonly version: ModuleVersion;
  readonly draft: ModuleDraft;
}

/** Display texts of the origins of versions. */
export const VERSION_ORIGINS: Readonly<Record<ModuleVersionOrigin, string>> = {
  [ModuleVersionOrigin.SAVED]: 'saved',
  [ModuleVersionOrigin.FILE]: 'file changed on disk',
  [ModuleVersionOrigin.FOUND]: 'initial version',
};

/** Newest first. */
export async function listVersions(client: UbiiClient, name: string): Promise<VersionList> {
  try {
    const { elements } = await client.call('moduleVersionList', { name });
    if (elements.length === 0)
      return { kind: 'none', sentence: 'No versions yet. The next save creates one.' };
    return { kind: 'list', versions: [...elements].sort((a, b) => b.number - a.number) };
  } catch (cause) {
    if (cause instanceof ConnectionError) {
      return {
        kind: 'none',
        sentence: 'The master, which stores the versions, cannot be reached.',
      };
    }
    if (!(cause instanceof ServiceError)) throw cause;
    const isOld = cause.code === 'unimplemented';
    const sentence =
      cause.code === 'not_found'
        ? 'No versions yet. The next save creates one.'
        : isOld
          ? 'This master does not store versions.'
          : cause.message;
    return { kind: 'none', sentence };
  }
}

/** Returns an earlier version; `undefined` when it is no longer stored. @throws ServiceError, ConnectionError */
export async function readVersion(
  client: UbiiClient,
  name: string,
  number: number,
): Promise<ProcessingModule | undefined> {
  const { elements } = await client.call('moduleVersionList', { name, number });
  return elements[0]?.module;
}
