/* Asking the preview endpoint what is understood of one answer. */
import { readPreview, type Preview } from "./preview.ts";

/** The sentence of a refusal, such as too many requests or a variant that is not (any more) this person's; null when the reply holds none. */
async function refusal(reply: Response): Promise<Preview | null> {
  const said = ((await reply.json()) as { error?: { message?: unknown } }).error?.message;
  return typeof said === "string" ? { ok: false, message: said, position: null } : null;
}

/** The preview of a text, with the rows of a diagram where `relations` asks for them; null when there is none now. */
export async function ask(url: string, answer: string, text: string, relations = false): Promise<Preview | null> {
  const headers = { "Content-Type": "application/json", "Accept-Language": document.documentElement.lang };
  try {
    const reply = await fetch(url, { method: "POST", headers, body: JSON.stringify(relations ? { answer, text, relations } : { answer, text }) });
    if (reply.status >= 400 && reply.status < 500) return await refusal(reply);
    return reply.ok ? readPreview(await reply.json()) : null;
  } catch {
    return null; // no connection, or no JSON: both mean that there is no preview now
  }
}
