/* Two people may write one draft, the same student in two tabs: what only one of them changed is nobody's quarrel. */
import type { Answers } from "./answers.ts";

export interface Merged {
  answers: Answers; // where both changed, mine
  conflicts: string[]; // names of the answers that both changed
  base: Answers; // what both grow out of from now on: what was taken over is no change of one's own
}

/** Merges two sets of answers that grew out of the same one; a missing answer is an empty one. */
export function merge(base: Answers, mine: Answers, theirs: Answers): Merged {
  const answers: Answers = { ...mine };
  const conflicts: string[] = [];
  const common: Answers = { ...base };
  for (const name of Object.keys(mine)) {
    const [was, here, there] = [base[name] ?? "", mine[name] ?? "", theirs[name] ?? ""];
    if (there === was) continue;
    if (here === was) answers[name] = there;
    if (here === was || here === there) common[name] = there;
    else conflicts.push(name);
  }
  return { answers, conflicts, base: common };
}

export function same(one: Answers, other: Answers): boolean {
  return [...Object.keys(one), ...Object.keys(other)].every((name) => (one[name] ?? "") === (other[name] ?? ""));
}
