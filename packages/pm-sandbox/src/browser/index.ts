export { createBrowserSandboxes, type BrowserSandboxOptions } from './create-browser-sandboxes.ts';
export { SANDBOX_WORKER_FILES, type SandboxWorkerFile } from '../sandbox-worker-files.ts';
export type { HostLibrary } from '../sandbox/worker-link.ts';
