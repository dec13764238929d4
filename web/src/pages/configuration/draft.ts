// SPDX-License-Identifier: MIT
// The configuration that is being edited: one text, seen as form, text and difference, checked before anything is applied.
import { computed, signal } from "@preact/signals";

import type { Change, Fault, Form } from "../../lib/config_form";
import { CommandError } from "../../rpc";
import type { Studio } from "../../studio";

export type Effect = "none" | "live" | "restart" | "reopen";

export interface Running {
  text: string;
  name?: string;
  hash?: string;
  dirty?: boolean;
  previous?: boolean;
}

interface Check {
  faults?: Fault[];
  plan?: string;
  effect?: Effect;
}

const kPatience = 350;

export class Draft {
  readonly running = signal<Running | null>(null);
  /** Null: nothing was loaded yet. */
  readonly text = signal<string | null>(null);
  readonly form = signal<Form | null>(null);
  /** The text of now has no form: it shows an older one. */
  readonly formOld = signal(false);
  readonly faults = signal<Fault[]>([]);
  readonly plan = signal("");
  readonly effect = signal<Effect | null>(null);
  /** A check of this text is under way. */
  readonly checking = signal(false);
  readonly problem = signal<Error | null>(null);
  readonly changed = computed(() => this.running.value !== null && this.text.value !== null && this.text.value !== this.running.value.text);
  readonly errors = computed(() => this.faults.value.filter((fault) => (fault.severity ?? "error") === "error"));
  readonly warnings = computed(() => this.faults.value.filter((fault) => fault.severity === "warning"));

  private turn = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Edits are made one after the other, each of the text that the one before gave. */
  private edits: Promise<void> = Promise.resolve();

  constructor(private readonly call: Studio["call"]) {}

  /** Fetches what runs; a draft that was changed stays as it is. */
  async load(): Promise<void> {
    const untouched = !this.changed.value;
    try {
      const running = await this.call<Running>("config.get");
      this.problem.value = null;
      this.running.value = { ...running, text: running.text ?? "" };
      if (untouched || this.text.value === null) this.text.value = running.text ?? "";
      await this.inspect();
    } catch (error) {
      this.problem.value = error as Error;
    }
  }

  /** What was typed; looked at when the typing rests. */
  type(text: string): void {
    this.text.value = text;
    this.checking.value = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.inspect(), kPatience);
  }

  /** Another text at once: imported, discarded, loaded. */
  async replace(text: string): Promise<void> {
    clearTimeout(this.timer);
    this.text.value = text;
    await this.inspect();
  }

  edit(changes: Change[]): Promise<void> {
    this.edits = this.edits.then(async () => {
      const answer = await this.call<{ text: string; faults?: Fault[] }>("config.edit", { text: this.text.value ?? "", changes });
      await this.replace(answer.text);
    }).catch((error: unknown) => {
      this.faults.value = faultsOf(error);
    });
    return this.edits;
  }

  async apply(): Promise<Effect> {
    const answer = await this.guarded<{ effect: Effect }>("config.apply", { text: this.text.value ?? "" });
    await this.load();
    return answer.effect;
  }

  async revert(): Promise<Effect> {
    const answer = await this.guarded<{ effect: Effect }>("config.revert", {});
    const running = await this.call<Running>("config.get");
    this.running.value = running;
    await this.replace(running.text);
    return answer.effect;
  }

  async save(name?: string): Promise<string> {
    const answer = await this.guarded<{ file?: string }>("config.save", name ? { name } : {});
    await this.load();
    return answer.file ?? "";
  }

  private async guarded<T>(method: string, params: object): Promise<T> {
    try {
      return await this.call<T>(method, params);
    } catch (error) {
      if (error instanceof CommandError && error.code === "invalid") this.faults.value = faultsOf(error);
      throw error;
    }
  }

  private async inspect(): Promise<void> {
    const text = this.text.value ?? "";
    const mine = ++this.turn;
    this.checking.value = true;
    const [form, check] = await Promise.allSettled([this.call<Form>("config.form", { text }), this.call<Check>("config.check", { text })]);
    if (mine !== this.turn) return;
    this.checking.value = false;
    this.formOld.value = form.status === "rejected";
    if (form.status === "fulfilled") this.form.value = { sections: form.value?.sections ?? [] };
    if (check.status === "fulfilled") {
      this.faults.value = check.value?.faults ?? [];
      this.plan.value = check.value?.plan ?? "";
      this.effect.value = check.value?.effect ?? null;
    } else {
      this.faults.value = faultsOf(check.reason);
      this.plan.value = "";
      this.effect.value = null;
    }
  }
}

function faultsOf(error: unknown): Fault[] {
  if (error instanceof CommandError) {
    const faults = (error.data as { faults?: Fault[] } | undefined)?.faults;
    if (faults && faults.length > 0) return faults;
  }
  return [{ severity: "error", what: error instanceof Error ? error.message : String(error) }];
}

const drafts = new WeakMap<object, Draft>();

/** The draft outlives the page that shows it: what was typed is there again when the user comes back. */
export function draftOf(studio: Studio): Draft {
  let draft = drafts.get(studio.store);
  if (!draft) drafts.set(studio.store, (draft = new Draft(studio.call)));
  return draft;
}
