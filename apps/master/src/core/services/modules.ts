import {
  ServiceError,
  type ModuleVersion,
  type ProcessingModule,
  ModuleOrigin,
  ModuleVersionOrigin,
  type Init,
  type ProcessingModuleList,
  type Success,
} from '@ubii/proto';
import { moduleProblems } from '@ubii/pm-sandbox';
import { READERS, PARTICIPANTS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { isSame, type HistoryKey } from '../library/module-history.ts';
import { quote } from '../texts/quote.ts';
import { definer, success, type CallTarget } from './define-service.ts';
import { grantOf } from '../access/caller.ts';
import { requireRoom } from '../library/require-room.ts';
import { matchesModule } from '../library/module-profiles.ts';
import { unknownModule, withOrigin } from '../library/module-library.ts';
import { requireElements, requireProfiles } from './list-limits.ts';
import type { ServiceCall } from './service-call.ts';

type Context = Pick<Core, 'modules' | 'history' | 'reload' | 'nodes' | 'sessions' | 'reports'> &
  Pick<Core, 'clients' | 'limitWatch'>;
const define = definer<keyof Context>();

/** Lists or returns kept versions of a module. [EX-40] */
const moduleVersionList = define('moduleVersionList', {
  roles: READERS,
  handle(context, { name, moduleId, number }) {
    if ((name === '') === (moduleId === '')) {
      throw new ServiceError(
        'invalid_argument',
        'The request has to give either the name of a stored module or the id of a module of a session.',
      );
    }
    const { history } = context;
    const key: HistoryKey = name === '' ? `instance ${moduleId}` : `module ${name}`;
    const what = name === '' ? `with the id ${quote(moduleId)}` : `named ${quote(name)}`;
    const versions = history.list(key);
    if (versions === undefined) {
      throw new ServiceError(
        'not_found',
        `The master keeps no versions of a module ${what}: it was not changed, or does not exist.`,
      );
    }
    const current = presentModule(context, name, moduleId);
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
  { modules, sessions }: Context,
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

/** Services on processing modules: stored, running, and the nodes that can run them. */
export const MODULE_SERVICES = [
  // [SE-22]
  define('processingModuleDatabaseSave', {
    roles: PARTICIPANTS,
    auditObject: nameOf,
    async handle(core, module, { caller }) {
      const { modules, reload, history } = core;
      const [problem] = moduleProblems(module);
      if (problem !== undefined) {
        throw new ServiceError(
          'invalid_argument',
          `The module ${quote(module.name)} cannot be stored: ${problem.message}`,
        );
      }
      requireRoom(core.limitWatch, modules.stored, 'ubii.processing.ProcessingModule', module);
      const before = modules.stored.get(module.name);
      const saved = await modules.save(module, grantOf(caller));
      reload.look();
      await history.record(`module ${module.name}`, before, saved, ModuleVersionOrigin.SAVED); // [EX-41]
      return saved;
    },
  }),
  // [SE-22]
  define('processingModuleDatabaseDelete', {
    roles: PARTICIPANTS,
    auditObject: nameOf,
    async handle({ modules }, module) {
      await modules.delete(requireName(module));
      return success('The module is deleted.');
    },
  }),
  // [SE-22]
  define('processingModuleDatabaseGet', {
    roles: READERS,
    handle({ modules, nodes }, profile) {
      const name = requireName(profile);
      const module =
        modules.list().find((one) => one.name === name) ?? nodes.offered(name, undefined);
      if (module === undefined) throw unknownModule(name);
      return { elements: [module] };
    },
  }),
  // [SE-22]
  define('processingModuleDatabaseGetList', {
    roles: READERS,
    handle(core, list) {
      const known = new Map<string, ProcessingModule>();
      for (const module of [...core.modules.list(), ...offeredModules(core)]) {
        const key = JSON.stringify([module.name, module.authors]);
        if (!known.has(key)) known.set(key, module);
      }
      return selected(core, [...known.values()], list);
    },
  }),
  // [SE-22]
  define('processingModuleDatabaseLocalGetList', {
    roles: READERS,
    handle: (core, list) => selected(core, core.modules.list(), list),
  }),
  // [SE-25]
  define('processingModuleDatabaseOnlineGetList', {
    roles: READERS,
    handle: () => ({ elements: [] }),
  }),
  // [SE-32]
  define('processingModuleRuntimeAdd', {
    roles: PARTICIPANTS,
    target: ofModules,
    handle: (core, list, call) => report(core, list, call, true),
  }),
  // [SE-32]
  define('processingModuleRuntimeRemove', {
    roles: PARTICIPANTS,
    target: ofModules,
    handle: (core, list, call) => report(core, list, call, false),
  }),
  define('processingModuleRuntimeGet', {
    roles: READERS,
    target: ({ id }) => ({ moduleId: id }),
    handle({ sessions }, { id }) {
      const found = sessions.findModule(id);
      if (found === undefined) {
        throw new ServiceError('not_found', `No session has a module with the id ${quote(id)}.`);
      }
      const { session, module } = found;
      return module.toMessage(session.id, session.isPaused);
    },
  }),
  define('processingModuleRuntimeGetList', {
    roles: READERS,
    handle: (core, list) => selected(core, core.sessions.runningModules(), list),
  }),
  moduleVersionList,
  // [PM-61]
  define('nodeList', {
    roles: READERS,
    handle: ({ sessions }) => ({ elements: sessions.nodes() }),
  }),
];

/** A report is about modules of one session: nodes report each by itself. */
function ofModules({ elements }: ProcessingModuleList): CallTarget {
  return { moduleId: elements[0]?.id ?? '' };
}

function report(
  { sessions, reports, limitWatch }: Context,
  { elements }: ProcessingModuleList,
  { caller }: ServiceCall,
  isRunning: boolean,
): Init<Success> {
  const unknown: string[] = [];
  for (const { id, nodeId } of requireElements({ limitWatch }, elements)) {
    const found = sessions.findModule(id);
    // Without an id, the caller means itself.
    const named = nodeId || (found?.module.nodeId ?? '');
    // A joined client can only report for itself. [AC-22]
    const reporter = caller.kind === 'client' ? caller.clientId : named;
    if (!reports.handleRuntime(reporter, id, isRunning)) unknown.push(id);
  }
  if (unknown.length > 0) {
    const ids = unknown.slice(0, 10).map(quote).join(', ');
    throw new ServiceError(
      'not_found',
      `No session has these modules on this node: ${ids}${unknown.length > 10 ? ', …' : ''}. The reports of the other modules were received.`,
      { details: { unknown } },
    );
  }
  return success('The reports of the modules were received.');
}

function selected(
  core: Context,
  modules: readonly ProcessingModule[],
  profiles: ProcessingModuleList | undefined,
): Init<ProcessingModuleList> {
  const wanted = requireProfiles(core, profiles?.elements ?? []);
  const elements =
    wanted.length === 0
      ? [...modules]
      : modules.filter((module) => wanted.some((profile) => matchesModule(module, profile)));
  return { elements };
}

function offeredModules({ clients }: Context): ProcessingModule[] {
  return [...clients.values()]
    .filter(({ status }) => status !== 'unavailable')
    .flatMap(({ spec }) => spec.processingModules)
    .map((module) => withOrigin(module, ModuleOrigin.MODULE_ORIGIN_NODE));
}

function requireName({ name }: ProcessingModule): string {
  if (name !== '') return name;
  throw new ServiceError('invalid_argument', 'The request names no module. Set its name.');
}

function nameOf(_core: Context, { name, id }: ProcessingModule): string {
  return name || id;
}
