import {
  ModuleOrigin,
  ModuleVersionOrigin,
  ServiceError,
  type ProcessingModule,
} from '@ubii/proto';
import { makerOf } from '../access/caller.ts';
import type { Core } from '../parts/core.ts';
import { requireRoom } from '../library/require-room.ts';
import { matchesModule } from '../library/module-profiles.ts';
import { unknownModule, withOrigin } from '../library/module-library.ts';
import { moduleProblems } from '@ubii/pm-sandbox';
import { quote } from '../texts/quote.ts';
import type { ServiceCall, ServiceHandler } from './handler.ts';
import { requireElements, requireProfiles } from './list-limits.ts';

/** `/services/processing_module/database/save` [SE-22] */
export const saveModule: ServiceHandler = async (core, request, { caller }) => {
  const module = request.processingModule!;
  const { modules } = core.processing;
  const [problem] = moduleProblems(module);
  if (problem !== undefined) {
    throw new ServiceError(
      'invalid_argument',
      `The module ${quote(module.name)} cannot be stored: ${problem.message}`,
    );
  }
  requireRoom(core.limitWatch, modules.stored, 'ubii.processing.ProcessingModule', module);
  const before = modules.stored.get(module.name);
  const saved = await modules.save(module, makerOf(caller));
  core.processing.reload.look();
  const { history } = core.processing;
  await history.record(`module ${module.name}`, before, saved, ModuleVersionOrigin.SAVED); // [EX-41]
  return { processingModule: saved };
};

/** `/services/processing_module/database/delete` [SE-22] */
export const deleteModule: ServiceHandler = async ({ processing }, request) => {
  await processing.modules.delete(requireName(request.processingModule!));
  return { success: { title: 'Success', message: 'The module is deleted.' } };
};

/** `/services/processing_module/database/get` [SE-22] */
export const getModule: ServiceHandler = ({ processing }, request) => {
  const name = requireName(request.processingModule!);
  const module =
    processing.modules.list().find((one) => one.name === name) ??
    processing.nodes.offered(name, '');
  if (module === undefined) throw unknownModule(name);
  return { processingModuleList: { elements: [module] } };
};

/** `/services/processing_module/database/get_list` [SE-22] */
export const listModules: ServiceHandler = (core, request) => {
  const known = new Map<string, ProcessingModule>();
  for (const module of [...core.processing.modules.list(), ...offeredModules(core)]) {
    const key = JSON.stringify([module.name, module.authors]);
    if (!known.has(key)) known.set(key, module);
  }
  return selected(core, [...known.values()], request.processingModuleList?.elements ?? []);
};

/** `/services/processing_module/database/local/get_list` [SE-22] */
export const listLocalModules: ServiceHandler = (core, request) =>
  selected(core, core.processing.modules.list(), request.processingModuleList?.elements ?? []);

/** `/services/processing_module/database/online/get_list` [SE-25] */
export const listOnlineModules: ServiceHandler = () => ({ processingModuleList: { elements: [] } });

/** `/services/processing_module/runtime/add` [SE-32] */
export const addRunningModules: ServiceHandler = (core, request, call) =>
  report(core, request, call, true);

/** `/services/processing_module/runtime/remove` [SE-32] */
export const removeRunningModules: ServiceHandler = (core, request, call) =>
  report(core, request, call, false);

/** `/services/processing_module/runtime/get` */
export const getRunningModule: ServiceHandler = ({ processing }, request) => {
  const { id } = request.processingModule!;
  const found = processing.sessions.findModule(id);
  if (found === undefined) {
    throw new ServiceError('not_found', `No session has a module with the id ${quote(id)}.`);
  }
  const { session, module } = found;
  return { processingModule: module.toMessage(session.id, session.isPaused) };
};

/** `/services/processing_module/runtime/get_list` */
export const listRunningModules: ServiceHandler = (core, request) =>
  selected(
    core,
    core.processing.sessions.runningModules(),
    request.processingModuleList?.elements ?? [],
  );

/** `/services/ubii/node_list` [PM-61] */
export const listNodes: ServiceHandler = ({ processing }) => ({
  nodeList: { elements: processing.sessions.nodes() },
});

function report(
  core: Core,
  request: Parameters<ServiceHandler>[1],
  { caller }: ServiceCall,
  isRunning: boolean,
): ReturnType<ServiceHandler> {
  const unknown: string[] = [];
  for (const { id, nodeId } of requireElements(core, request.processingModuleList!.elements)) {
    const found = core.processing.sessions.findModule(id);
    // Without an id, the caller means itself.
    const named = nodeId || (found?.module.nodeId ?? '');
    // A joined client can only report for itself. [AC-22]
    const reporter = caller.kind === 'client' ? caller.clientId : named;
    if (!core.processing.handleReport(reporter, id, isRunning)) unknown.push(id);
  }
  if (unknown.length > 0) {
    const ids = unknown.slice(0, 10).map(quote).join(', ');
    throw new ServiceError(
      'not_found',
      `No session has these modules on this node: ${ids}${unknown.length > 10 ? ', …' : ''}. The reports of the others were received.`,
      { details: { unknown } },
    );
  }
  return { success: { title: 'Success', message: 'The reports of the modules were received.' } };
}

function selected(
  core: Core,
  modules: readonly ProcessingModule[],
  profiles: readonly ProcessingModule[],
): Awaited<ReturnType<ServiceHandler>> {
  const wanted = requireProfiles(core, profiles);
  const elements =
    wanted.length === 0
      ? [...modules]
      : modules.filter((module) => wanted.some((profile) => matchesModule(module, profile)));
  return { processingModuleList: { elements } };
}

function offeredModules({ clients }: Core): ProcessingModule[] {
  return [...clients.values()]
    .filter(({ status }) => status !== 'unavailable')
    .flatMap(({ spec }) => spec.processingModules)
    .map((module) => withOrigin(module, ModuleOrigin.MODULE_ORIGIN_NODE));
}

function requireName({ name }: ProcessingModule): string {
  if (name !== '') return name;
  throw new ServiceError('invalid_argument', 'The request names no module. Set its name.');
}
