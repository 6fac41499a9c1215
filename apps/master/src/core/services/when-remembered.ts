import type { ServiceHandler } from './handler.ts';

/** Answers when what starts with the next master is on the disk: what was answered, stands [SE-24]. */
export function whenRemembered(handle: ServiceHandler): ServiceHandler {
  return async (core, request, ...rest) => {
    const reply = await handle(core, request, ...rest);
    const id = reply.session?.id || (request.session?.id ?? '');
    await core.processing.sessionLibrary.remembered(id);
    return reply;
  };
}
