export { loadModuleFolder, type FolderProblem, type LoadedFolder } from './load-module-folder.ts';
export { watchModuleFolder, type FolderWatch } from './watch-module-folder.ts';
