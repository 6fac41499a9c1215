/** A problem's sentence with the name it is about set apart. */
export interface ProblemParts {
  readonly subject: string | undefined;
  readonly text: string;
}

/** Splits the name off the sentence when it begins with it, so that it can be set in bold. */
export function problemParts(text: string, name: string | undefined): ProblemParts {
  if (name !== undefined && name !== '' && text.startsWith(`${name} `)) {
    return { subject: name, text: text.slice(name.length + 1) };
  }
  return { subject: name || undefined, text };
}
