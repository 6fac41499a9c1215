import { ServiceError, type ModuleVersion, type ProcessingModule } from '@ubii/proto';
import { READERS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { isSame, type HistoryKey } from '../library/module-history.ts';
import { quote } from '../texts/quote.ts';
import { definer } from './define-service.ts';

type Parts = Pick<Core, 'history' | 'modules' | 'sessions'>;

/** Lists or returns kept versions of a module. [EX-40] */
export const moduleVersionList = definer<keyof Parts>()('moduleVersionList', {
  roles: READERS,
  handle(parts, { name, moduleId, number }) {
    if ((name === '') === (moduleId === '')) {
      throw new ServiceError(
        'invalid_argument',
        'The request has to give either the name of a stored module or the id of a module of a session.',
      );
    }
    const { history } = parts;
    const key: HistoryKey = name === '' ? `instance ${moduleId}` : `module ${name}`;
    const what = name === '' ? `with the id ${quote(moduleId)}` : `named ${quote(name)}`;
    const versions = history.list(key);
    if (versions === undefined) {
      throw new ServiceError(
        'not_found',
        `The master keeps no versions of a module ${what}: it was not changed, or does not exist.`,
      );
    }
    const current = presentModule(parts, name, moduleId);
    const isCurrent = newestIsCurrent(history, key, versions, current);
    if (number === 0) {
      const elements = versions.map((version, index) => ({
        ...version,
        current: isCurrent && index === 0,
      }));
      return { elements };
    }
    const found = history.get(key, number);
    if (found === undefined) {
      throw new ServiceError(
        'not_found',
        `The version ${number} of the module ${what} is not kept. The list shows the versions that are.`,
      );
    }
    const element = { ...found, current: isCurrent && number === versions[0]?.number };
    return { elements: [element] };
  },
});

function presentModule(
  { modules, sessions }: Parts,
  name: string,
  moduleId: string,
): ProcessingModule | undefined {
  return name === '' ? sessions.findModule(moduleId)?.module.spec : modules.stored.get(name);
}

function newestIsCurrent(
  history: Core['history'],
  key: HistoryKey,
  versions: readonly ModuleVersion[],
  current: ProcessingModule | undefined,
): boolean {
  const newest = history.get(key, versions[0]?.number ?? 0)?.module;
  return newest !== undefined && current !== undefined && isSame(newest, current);
}
