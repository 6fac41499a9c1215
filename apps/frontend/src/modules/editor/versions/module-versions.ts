import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import {
  ModuleVersionOrigin,
  ServiceError,
  type ModuleVersion,
  type ProcessingModule,
} from '@ubii/proto';

/** Earlier versions of a module, or why there are none to show. */
export type VersionList =
  | { readonly kind: 'list'; readonly versions: readonly ModuleVersion[] }
  | { readonly kind: 'none'; readonly sentence: string };

/** Where a version is from, for people. */
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

/** The module as it was; `undefined` when it is not kept any more. @throws ServiceError, ConnectionError */
export async function readVersion(
  client: UbiiClient,
  name: string,
  number: number,
): Promise<ProcessingModule | undefined> {
  const { elements } = await client.call('moduleVersionList', { name, number });
  return elements[0]?.module;
}
