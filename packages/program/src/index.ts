export {
  createAtomicallySync,
  SECRET_MODE,
  writeAtomically,
  writeAtomicallySync,
} from './atomic-files.ts';
export { ConfigError } from './config-error.ts';
export { formatHelp } from './format-help.ts';
export { isLogged, type LogLevel } from './log-levels.ts';
export { environmentName, flagName, option } from './option.ts';
export type { Option, OptionTable, OptionValues, ProgramOptions } from './option.ts';
export {
  parseChoice,
  parseFetchOrigins,
  parseList,
  parseName,
  parseNumber,
  parsePath,
  parseSwitch,
  parseWholeNumber,
} from './parse-values.ts';
export { HELP_OPTIONS, logLevelOption } from './program-options.ts';
export { readOptions, type Environment, type ReadOptions } from './read-options.ts';
export { asksForHelp, exitOnConfigError, readVersion, runProgram } from './run-program.ts';
export { isProcessRunning, onStopRequest, shutDownOnRequest, type Shutdown } from './stopping.ts';
export { userDataFolder, userStateFolder } from './user-folders.ts';
