import { fromJson, toJson, type Init, type ProcessingModule, type Session } from '@ubii/proto';

const SESSION = 'ubii.sessions.Session';

/** Completes an example for display: examples only name their modules, and a master fills in the rest. [SE-1, SE-2] */
export function completeExample(
  spec: Init<Session>,
  library: readonly Pick<ProcessingModule, 'name' | 'inputs' | 'outputs' | 'processingMode'>[],
): Session {
  const session = fromJson(SESSION, toJson(SESSION, spec));
  const free = [...session.ioMappings];
  session.processingModules.forEach((module, index) => {
    const known = library.find(({ name }) => name === module.name);
    const given = module.id;
    module.id = given || `module ${index}`;
    module.inputs = module.inputs.length > 0 ? module.inputs : (known?.inputs ?? []);
    module.outputs = module.outputs.length > 0 ? module.outputs : (known?.outputs ?? []);
    module.processingMode ??= known?.processingMode;
    const at = free.findIndex(({ processingModuleId, processingModuleName }) =>
      processingModuleId === ''
        ? processingModuleName === module.name
        : processingModuleId === given,
    );
    const [mapping] = at < 0 ? [] : free.splice(at, 1);
    if (mapping) mapping.processingModuleId = module.id;
  });
  return session;
}
