import { readFileSync } from 'node:fs';

import { inRoot } from './repository.mjs';

/** Definitions of error codes, and the pages that document them. */
const sources = [
  {
    code: 'packages/proto/src/service-error.ts',
    /** The list `SERVICE_ERROR_CODES`. */
    block: /SERVICE_ERROR_CODES = \[([^\]]*)\]/,
    entry: /'([a-z_]+)'/g,
    page: 'docs/errors.md',
    /** The page above its other lists. */
    section: /^.*?(?=^## Why a client is not admitted)/ms,
    row: /^\| `([a-z_]+)`/gm,
  },
  {
    code: 'packages/client-web/src/core/connection/join.ts',
    /** The union `JoinProblem`. */
    block: /type JoinProblem =(.*?);/s,
    entry: /'([a-z_]+)'/g,
    page: 'docs/errors.md',
    section: /^## Why a client is not admitted.*?(?=^## Problems of a master)/ms,
    row: /^\| `([a-z_]+)`/gm,
  },
  {
    code: 'apps/master/src/core/checks/problem.ts',
    /** The union `MasterProblemCode`. */
    block: /type MasterProblemCode =(.*?);/s,
    entry: /'([a-z_]+)'/g,
    page: 'docs/errors.md',
    section: /^## Problems of a master.*?(?=^## Problems of sessions)/ms,
    row: /^\| `([a-z_]+)`/gm,
  },
  {
    code: 'apps/master/src/core/sessions/problems.ts',
    /** The union `ProblemCode`. */
    block: /type ProblemCode =(.*?);/s,
    entry: /'([a-z_]+)'/g,
    page: 'docs/errors.md',
    section: /^## Problems of sessions.*/ms,
    /** A row may be about several codes, all in its first column. */
    row: /(?<=^\|[^|\n]*)`([a-z_]+)`(?=[^|\n]*\|)/gm,
  },
  {
    code: 'apps/master/src/adapters/ws/close-codes.ts',
    block: /(.*)/s,
    /** 4000 and more are ours, the others are the RFC's. */
    entry: /(4\d{3})[,;]$/gm,
    page: 'docs/spec/extensions.md',
    section: /.*/s,
    row: /^\| (4\d{3})\b/gm,
  },
];

/**
 * Compares the codes of the code with the tables of the documentation.
 *
 * @returns {string[]} one sentence for each difference
 */
export function findUndocumentedErrors() {
  return sources.flatMap(({ code, block, entry, page, section, row }) => {
    const text = readFileSync(inRoot(code), 'utf8');
    const inCode = matches(block.exec(text)?.[1] ?? '', entry);
    const inPage = matches(section.exec(readFileSync(inRoot(page), 'utf8'))?.[0] ?? '', row);
    return [
      ...(inCode.length > 0 ? [] : [`No codes were found in ${code}.`]),
      ...inCode
        .filter((each) => !inPage.includes(each))
        .map((each) => `${page} has no row for ${each} of ${code}.`),
      ...inPage
        .filter((each) => !inCode.includes(each))
        .map((each) => `${page} has a row for ${each}, which ${code} does not know.`),
    ];
  });
}

/** @param {string} text @param {RegExp} pattern with one group */
function matches(text, pattern) {
  return [...text.matchAll(pattern)].map(([, match]) => match);
}
