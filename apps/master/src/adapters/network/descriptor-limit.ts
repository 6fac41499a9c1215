import { readFileSync } from 'node:fs';

/**
 * Returns the most files and connections this process may have open (`ulimit -n`); undefined when the system sets no
 * limit or does not report it. Node.js raises the soft limit to the hard limit.
 */
export function descriptorLimit(): number | undefined {
  if (process.platform === 'win32') return undefined;
  const limit = process.platform === 'linux' ? ofLinux() : ofReport();
  return limit !== undefined && Number.isSafeInteger(limit) && limit > 0 ? limit : undefined;
}

function ofLinux(): number | undefined {
  try {
    const limits = readFileSync('/proc/self/limits', 'utf8');
    return Number(/^Max open files\s+(\d+)/m.exec(limits)?.[1] ?? Number.NaN);
  } catch {
    return undefined;
  }
}

/** https://nodejs.org/api/report.html: "userLimits" */
function ofReport(): number | undefined {
  const report = process.report.getReport() as {
    readonly userLimits?: { readonly open_files?: { readonly soft?: number | 'unlimited' } };
  };
  const soft = report.userLimits?.open_files?.soft;
  return typeof soft === 'number' ? soft : undefined;
}
