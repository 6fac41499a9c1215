import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ModuleVersionOrigin, type ModuleVersion, type ProcessingModule } from '@ubii/proto';
import { tryRequest, type RequestError } from '../../../connection/useAttempt.ts';
import type { ModuleDraft } from '../../draft/module-draft.ts';

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

const NO_VERSIONS = 'No versions yet. The next save creates one.';

/** Newest first. */
export async function listVersions(client: UbiiClient, name: string): Promise<VersionList> {
  let sentence = NO_VERSIONS;
  const reply = await tryRequest(
    () => client.call('moduleVersionList', { name }),
    (cause) => (sentence = whyNone(cause)),
  );
  if (reply === undefined || reply.elements.length === 0) return { kind: 'none', sentence };
  return { kind: 'list', versions: [...reply.elements].sort((a, b) => b.number - a.number) };
}

function whyNone(cause: RequestError): string {
  if (cause instanceof ConnectionError)
    return 'The master, which stores the versions, cannot be reached.';
  switch (cause.code) {
    case 'not_found':
      return NO_VERSIONS;
    case 'unimplemented':
      return 'This master does not store versions.';
    default:
      return cause.message;
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
